// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/undistortion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tegata/base/error.h"

namespace tegata {
namespace {

Camera barrel_camera() {
  Camera camera;
  camera.name = "wide";
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 120.0;
  camera.cx = 80.0;
  camera.cy = 60.0;
  camera.distortion = {-0.2, 0.02, 0.001, -0.001, 0.0};
  return camera;
}

TEST(Undistortion, UndistortedPixelsComeFromWhereTheLensPutThem) {
  const Camera camera = barrel_camera();
  // A disk in the ideal picture, drawn as the lens shows it.
  const auto in_disk = [](const Eigen::Vector2d& p) {
    return (p - Eigen::Vector2d(30, 40)).norm();
  };
  Silhouette seen(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (in_disk(undistort_pixel(camera, {x, y})) < 20.0) seen(x, y) = PixelLabel::hand;
    }
  }
  const Undistortion undistortion(camera);
  const Silhouette ideal = undistortion.apply(seen);
  const Eigen::Vector2d shift(camera.cx - undistortion.camera().cx,
                              camera.cy - undistortion.camera().cy);
  for (int y = 0; y < ideal.height(); ++y) {
    for (int x = 0; x < ideal.width(); ++x) {
      const double distance = in_disk(Eigen::Vector2d(x, y) + shift);
      if (distance < 19.0) {
        EXPECT_EQ(ideal(x, y), PixelLabel::hand) << x << ' ' << y;
      }
      if (distance > 21.0) {
        EXPECT_NE(ideal(x, y), PixelLabel::hand) << x << ' ' << y;
      }
    }
  }
}

TEST(Undistortion, WhatTheDistortedPictureDoesNotShowIsUnknown) {
  Camera camera = barrel_camera();
  camera.distortion[0] = 0.2;  // a pincushion: the ideal picture's corners were not taken
  const Silhouette ideal =
      Undistortion(camera).apply(Silhouette(camera.width, camera.height, PixelLabel::hand));
  EXPECT_EQ(ideal(0, 0), PixelLabel::unknown);
  EXPECT_EQ(ideal(159, 119), PixelLabel::unknown);
  EXPECT_EQ(ideal(80, 60), PixelLabel::hand);
}

TEST(Undistortion, AHandAtTheEdgeOfABarrelsPictureIsNotLost) {
  const Camera camera = barrel_camera();
  Silhouette seen(camera.width, camera.height);
  for (int y = 40; y < 80; ++y) {
    for (int x = 0; x < 12; ++x) seen(x, y) = PixelLabel::hand;
  }
  const Undistortion undistortion(camera);
  const Silhouette ideal = undistortion.apply(seen);
  EXPECT_EQ(count_pixels(ideal, PixelLabel::unknown), 0U);
  // The outermost column of the lens's picture, half way up, is in this one.
  const Eigen::Vector2d edge = undistort_pixel(camera, {1.0, 60.0});
  ASSERT_LT(edge.x(), -5.0);
  const Camera& wide = undistortion.camera();
  const Eigen::Vector2d there = edge + Eigen::Vector2d(wide.cx - camera.cx, wide.cy - camera.cy);
  ASSERT_TRUE(wide.contains(there));
  EXPECT_EQ(ideal(static_cast<int>(there.x() + 0.5), static_cast<int>(there.y() + 0.5)),
            PixelLabel::hand);
}

TEST(Undistortion, NoStripAtAnEdgeHidesTheHand) {
  Camera camera = barrel_camera();
  camera.distortion = {0.0, 0.0, -0.03, 0.02, 0.0};  // shifts the picture's edges out of it
  const Undistortion undistortion(camera);
  const Silhouette ideal =
      undistortion.apply(Silhouette(camera.width, camera.height, PixelLabel::hand));
  EXPECT_EQ(count_pixels(ideal, PixelLabel::unknown), 0U);
  const Camera& cut = undistortion.camera();
  EXPECT_EQ(ideal.width(), cut.width);
  EXPECT_EQ(ideal.height(), cut.height);
  EXPECT_LT(cut.width * cut.height, camera.width * camera.height);
  EXPECT_GT(cut.width * cut.height, 0.8 * camera.width * camera.height);
  // A pixel is seen in the same direction as before.
  const Eigen::Vector2d shift(camera.cx - cut.cx, camera.cy - cut.cy);
  EXPECT_LT((pixel_direction(camera.undistorted(), Eigen::Vector2d(50, 40) + shift) -
             pixel_direction(cut, {50, 40}))
                .norm(),
            1e-12);
}

TEST(Undistortion, ALensPolynomialThatFoldsBackDoesNotShowTheHandTwice) {
  Camera camera = barrel_camera();
  camera.distortion = {0.0, 0.0, 0.0, 0.0, -6.0};  // r - 6 r^7 grows up to r = 0.53, 64 pixels
  const Silhouette ideal =
      Undistortion(camera).apply(Silhouette(camera.width, camera.height, PixelLabel::hand));
  for (int x = 0; x < camera.width; ++x) {
    EXPECT_EQ(ideal(x, 60), std::abs(x - 80) <= 64 ? PixelLabel::hand : PixelLabel::unknown) << x;
  }
}

TEST(Undistortion, AnIdealLensChangesNothing) {
  Camera camera = barrel_camera();
  camera.distortion = {};
  Silhouette silhouette(camera.width, camera.height);
  silhouette(0, 0) = PixelLabel::hand;
  silhouette(159, 119) = PixelLabel::unknown;
  EXPECT_EQ(Undistortion(camera).apply(silhouette), silhouette);
}

TEST(Undistortion, ASizeOtherThanTheCalibrationsNamesTheCamera) {
  try {
    Undistortion(barrel_camera()).apply(Silhouette(120, 160));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'wide'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tegata
