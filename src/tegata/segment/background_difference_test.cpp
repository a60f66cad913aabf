// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/background_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"
#include "tegata/base/random.h"

namespace tegata {
namespace {

constexpr int kWallWidth = 200, kWallHeight = 160;

double outside_ellipse(int x, int y) { return std::hypot(x - 90.4, 1.3 * (y - 80.2)) - 45.0; }

// A room with a chequered wall, with or without a grey ellipse in front.
CameraImage photograph(bool hand, double light, int channels, Random& random) {
  CameraImage picture{Image<std::uint16_t>(kWallWidth, kWallHeight, 0, channels), 8};
  for (int y = 0; y < kWallHeight; ++y) {
    for (int x = 0; x < kWallWidth; ++x) {
      const double share = hand ? 0.5 * std::erfc(outside_ellipse(x, y) / 1.4) : 0.0;
      for (int c = 0; c < channels; ++c) {
        const double wall = (x / 20 + y / 20) % 2 == 0 ? 60.0 : 90.0 + 15.0 * c;
        const double value = light + wall + share * (180.0 - wall) + random.normal(0.0, 2.0);
        picture.values(x, y, c) =
            static_cast<std::uint16_t>(std::clamp(std::lround(value), 0L, 255L));
      }
    }
  }
  return picture;
}

Silhouette ellipse_truth() {
  Silhouette silhouette(kWallWidth, kWallHeight);
  for (int y = 0; y < kWallHeight; ++y) {
    for (int x = 0; x < kWallWidth; ++x) {
      if (outside_ellipse(x, y) < 0.0) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

TEST(SegmentBackground, FindsWhatIsNewAlsoInADarkerPicture) {
  Random random(1);
  for (const int channels : {1, 3}) {
    for (const double light : {0.0, -12.0}) {
      const CameraImage empty = photograph(false, 0.0, channels, random);
      const CameraImage picture = photograph(true, light, channels, random);
      SegmentationReport report;
      const Silhouette found = segment_background(picture, empty, {}, &report);
      EXPECT_GT(intersection_over_union(found, ellipse_truth()), 0.98) << channels << ' ' << light;
      EXPECT_NEAR(static_cast<double>(report.hand_pixels),
                  static_cast<double>(count_pixels(ellipse_truth(), PixelLabel::hand)),
                  0.01 * static_cast<double>(report.hand_pixels));
      EXPECT_GT(report.threshold, 6.0);
      EXPECT_LT(report.threshold, 30.0);
    }
  }
}

TEST(SegmentBackground, TheEmptySceneItselfHoldsNothing) {
  Random random(2);
  const CameraImage empty = photograph(false, 0.0, 3, random);
  EXPECT_EQ(count_pixels(segment_background(empty, empty), PixelLabel::hand), 0U);
  const CameraImage again = photograph(false, 5.0, 3, random);
  EXPECT_EQ(count_pixels(segment_background(again, empty), PixelLabel::hand), 0U);
}

TEST(SegmentBackground, RefusesABackgroundOfAnotherKind) {
  const CameraImage picture{Image<std::uint16_t>(20, 10, 0, 3), 8};
  EXPECT_THROW(segment_background(picture, {Image<std::uint16_t>(10, 20, 0, 3), 8}), Error);
  EXPECT_THROW(segment_background(picture, {Image<std::uint16_t>(20, 10, 0, 1), 8}), Error);
  EXPECT_THROW(segment_background(picture, {Image<std::uint16_t>(20, 10, 0, 3), 16}), Error);
}

}  // namespace
}  // namespace tegata
