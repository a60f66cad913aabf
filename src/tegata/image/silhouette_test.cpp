// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr PixelLabel kHand = PixelLabel::hand;
constexpr PixelLabel kUnknown = PixelLabel::unknown;

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

TEST(Silhouette, CountsEachLabel) {
  Silhouette silhouette(4, 3);
  silhouette(1, 1) = kHand;
  silhouette(2, 1) = kHand;
  silhouette(3, 2) = kUnknown;
  EXPECT_EQ(count_pixels(silhouette, kHand), 2U);
  EXPECT_EQ(count_pixels(silhouette, kUnknown), 1U);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::background), 9U);
}

TEST(Silhouette, UndistortedPixelsComeFromWhereTheLensPutThem) {
  const Camera camera = barrel_camera();
  // A disk in the ideal picture, drawn as the lens shows it.
  const auto in_disk = [](const Eigen::Vector2d& p) {
    return (p - Eigen::Vector2d(30, 40)).norm();
  };
  Silhouette seen(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (in_disk(undistort_pixel(camera, {x, y})) < 20.0) seen(x, y) = kHand;
    }
  }
  const Silhouette ideal = undistort(seen, camera);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double distance = in_disk(Eigen::Vector2d(x, y));
      if (distance < 19.0) {
        EXPECT_EQ(ideal(x, y), kHand) << x << ' ' << y;
      }
      if (distance > 21.0) {
        EXPECT_NE(ideal(x, y), kHand) << x << ' ' << y;
      }
    }
  }
}

TEST(Silhouette, WhatTheDistortedPictureDoesNotShowIsUnknown) {
  Camera camera = barrel_camera();
  camera.distortion[0] = 0.2;  // a pincushion: the ideal picture's corners were not taken
  const Silhouette ideal = undistort(Silhouette(camera.width, camera.height, kHand), camera);
  EXPECT_EQ(ideal(0, 0), kUnknown);
  EXPECT_EQ(ideal(159, 119), kUnknown);
  EXPECT_EQ(ideal(80, 60), kHand);
}

TEST(Silhouette, ALensPolynomialThatFoldsBackDoesNotShowTheHandTwice) {
  Camera camera = barrel_camera();
  camera.distortion = {0.0, 0.0, 0.0, 0.0, -6.0};  // r - 6 r^7 grows up to r = 0.53, 64 pixels
  const Silhouette ideal = undistort(Silhouette(camera.width, camera.height, kHand), camera);
  for (int x = 0; x < camera.width; ++x) {
    EXPECT_EQ(ideal(x, 60), std::abs(x - 80) <= 64 ? kHand : kUnknown) << x;
  }
}

TEST(Silhouette, AnIdealLensChangesNothing) {
  Camera camera = barrel_camera();
  camera.distortion = {};
  Silhouette silhouette(camera.width, camera.height);
  silhouette(0, 0) = kHand;
  silhouette(159, 119) = kUnknown;
  EXPECT_EQ(undistort(silhouette, camera), silhouette);
}

TEST(Silhouette, ASizeOtherThanTheCalibrationsNamesTheCamera) {
  try {
    undistort(Silhouette(120, 160), barrel_camera());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'wide'"), std::string::npos) << error.what();
  }
}

TEST(IntersectionOverUnion, LeavesOutUnknownPixels) {
  Silhouette a(6, 1), b(6, 1);
  for (int x = 0; x < 4; ++x) a(x, 0) = kHand;
  for (int x = 2; x < 6; ++x) b(x, 0) = kHand;
  EXPECT_DOUBLE_EQ(intersection_over_union(a, b), 2.0 / 6.0);
  a(5, 0) = kUnknown;
  b(0, 0) = kUnknown;
  EXPECT_DOUBLE_EQ(intersection_over_union(a, b), 2.0 / 4.0);
}

TEST(IntersectionOverUnion, IsZeroWithoutAHandAndRefusesTwoSizes) {
  EXPECT_EQ(intersection_over_union(Silhouette(3, 2), Silhouette(3, 2)), 0.0);
  EXPECT_THROW(intersection_over_union(Silhouette(3, 2), Silhouette(2, 3)), Error);
}

}  // namespace
}  // namespace tegata
