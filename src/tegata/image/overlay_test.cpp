// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/overlay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tegata/base/error.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

constexpr Colour kRed = {255, 0, 0};

CameraImage grey(int width, int height, std::uint16_t value = 100) {
  return {Image<std::uint16_t>(width, height, value, 3), 8};
}

bool is_red(const CameraImage& picture, int x, int y) {
  return picture.values(x, y, 0) == 255 && picture.values(x, y, 1) == 0;
}

// A sphere of radius 0.1 at the origin.
TriangleMesh sphere() {
  constexpr std::uint32_t kRings = 24, kSectors = 48;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= kRings; ++i) {
    for (std::uint32_t j = 0; j < kSectors; ++j) {
      const double polar = std::numbers::pi * i / kRings,
                   around = 2.0 * std::numbers::pi * j / kSectors;
      mesh.vertices.emplace_back(0.1 * std::sin(polar) * std::cos(around),
                                 0.1 * std::sin(polar) * std::sin(around), 0.1 * std::cos(polar));
    }
  }
  for (std::uint32_t i = 0; i < kRings; ++i) {
    for (std::uint32_t j = 0; j < kSectors; ++j) {
      const std::uint32_t a = i * kSectors + j, b = i * kSectors + (j + 1) % kSectors;
      mesh.triangles.push_back({a, a + kSectors, b});
      mesh.triangles.push_back({b, a + kSectors, b + kSectors});
    }
  }
  return mesh;
}

Camera front_camera() {
  Camera camera;
  camera.name = "front";
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 400.0;
  camera.cx = 79.5;
  camera.cy = 59.5;
  camera.camera_from_world.translation.z() = 1.0;
  return camera;
}

TEST(ForDisplay, SpreadsTheCountsOfARawInfraredPicture) {
  CameraImage raw{Image<std::uint16_t>(100, 100), 16};
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) raw.values(x, y) = static_cast<std::uint16_t>(1000 + x);
  }
  raw.values(50, 50) = 65535;  // one hot pixel must not darken all others
  const CameraImage shown = for_display(raw);
  EXPECT_EQ(shown.bits, 8);
  ASSERT_EQ(shown.values.channels(), 3);
  EXPECT_LT(shown.values(0, 3, 1), 3);
  EXPECT_GT(shown.values(99, 3, 2), 252);
  EXPECT_EQ(shown.values(50, 50, 0), 255);
}

TEST(ForDisplay, KeepsColourAndBringsSixteenBitsToEight) {
  CameraImage picture{Image<std::uint16_t>(2, 1, 0, 3), 16};
  picture.values(1, 0, 0) = 65535;
  picture.values(1, 0, 1) = 32896;
  const CameraImage shown = for_display(picture);
  EXPECT_EQ(shown.values(1, 0, 0), 255);
  EXPECT_EQ(shown.values(1, 0, 1), 128);
  EXPECT_EQ(shown.values(1, 0, 2), 0);
  EXPECT_EQ(shown.values(0, 0, 0), 0);
}

TEST(ForDisplay, ManagesAPictureOfOneValueAndRefusesNone) {
  EXPECT_EQ(for_display({Image<std::uint16_t>(3, 3, 7), 8}).values(1, 1), 0);
  EXPECT_THROW(for_display(CameraImage{}), Error);
}

TEST(DrawOutline, IsAsWideAsAskedAndStaysOnTheBorder) {
  Silhouette silhouette(40, 30);
  for (int y = 10; y < 20; ++y) {
    for (int x = 10; x < 25; ++x) silhouette(x, y) = PixelLabel::hand;
  }
  for (const int width : {1, 2, 3, 4}) {
    CameraImage picture = grey(40, 30);
    draw_outline(picture, silhouette, kRed, width);
    int across = 0;
    for (int x = 0; x < 18; ++x) across += is_red(picture, x, 15) ? 1 : 0;
    EXPECT_EQ(across, width);
    EXPECT_TRUE(is_red(picture, 10, 15));
    EXPECT_FALSE(is_red(picture, 17, 15));
  }
}

TEST(DrawOutline, DrawsNothingWithoutAHand) {
  CameraImage picture = grey(20, 10);
  draw_outline(picture, Silhouette(20, 10), kRed, 3);
  EXPECT_EQ(picture.values, grey(20, 10).values);
}

TEST(DrawOutline, RefusesAnotherSizeAndARawPicture) {
  CameraImage picture = grey(20, 10);
  EXPECT_THROW(draw_outline(picture, Silhouette(10, 20), kRed, 1), Error);
  CameraImage raw{Image<std::uint16_t>(20, 10), 16};
  EXPECT_THROW(draw_outline(raw, Silhouette(20, 10), kRed, 1), Error);
}

TEST(Shrunk, AveragesWholeBlocksDownToTheWidth) {
  CameraImage picture{Image<std::uint16_t>(10, 7), 16};
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 7; ++y) picture.values(x, y) = static_cast<std::uint16_t>(10 * x + y);
  }
  const CameraImage small = shrunk(picture, 4);
  EXPECT_EQ(small.values.width(), 3);
  EXPECT_EQ(small.values.height(), 2);
  EXPECT_EQ(small.values(1, 1), 44);
  EXPECT_EQ(shrunk(picture, 10).values, picture.values);
  EXPECT_EQ(shrunk(picture, 1).values.width(), 1);
  EXPECT_EQ(shrunk(picture, 1).values.height(), 1);
}

TEST(ContactSheet, PutsPicturesInRowsOnPaper) {
  const CameraImage sheet =
      contact_sheet({grey(10, 6, 1), grey(4, 8, 2), grey(10, 8, 3)}, 2, {9, 9, 9});
  EXPECT_EQ(sheet.values.width(), 20);
  EXPECT_EQ(sheet.values.height(), 16);
  EXPECT_EQ(sheet.values(5, 4, 0), 1);
  EXPECT_EQ(sheet.values(5, 0, 0), 9);  // above the lower picture
  EXPECT_EQ(sheet.values(15, 4, 2), 2);
  EXPECT_EQ(sheet.values(5, 12, 1), 3);
  EXPECT_EQ(sheet.values(15, 12, 1), 9);  // no fourth picture
  EXPECT_TRUE(contact_sheet({}, 3, kRed).values.empty());
}

TEST(DrawShaded, IsBrightWhereTheSurfaceFacesTheCameraAndDarkAtTheRim) {
  const Camera camera = front_camera();
  const TriangleMesh mesh = sphere();
  CameraImage picture = grey(160, 120);
  draw_shaded(picture, mesh, camera, {200, 100, 50});
  const Silhouette silhouette = render_silhouette(mesh, camera);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (silhouette(x, y) != PixelLabel::hand) {
        ASSERT_EQ(picture.values(x, y, 2), 100);
        continue;
      }
      // Lambert's law on a sphere: the cosine follows from the distance to the picture's middle.
      const double share = std::min(1.0, std::hypot(x - 79.5, y - 59.5) / 40.2);
      const double expected = 200.0 * (0.2 + 0.8 * std::sqrt(1.0 - share * share));
      if (share < 0.95) {
        ASSERT_NEAR(picture.values(x, y, 0), expected, 3.0) << x << ' ' << y;
      }
    }
  }
  EXPECT_NEAR(picture.values(79, 59, 0), 200, 1);
  EXPECT_NEAR(picture.values(79, 59, 2), 50, 1);
}

TEST(DrawShaded, RefusesAPictureOfAnotherSizeAndNamesTheCamera) {
  CameraImage picture = grey(120, 160);
  try {
    draw_shaded(picture, sphere(), front_camera(), kRed);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'front'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tegata
