// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/border.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr int kSize = 100;

// How far a pixel lies beyond of a disk of 30 pixels radius.
double beyond(int x, int y) { return std::hypot(x - 50.3, y - 49.6) - 30.0; }

Silhouette disk(double larger) {
  Silhouette silhouette(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (beyond(x, y) < larger) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

// The share of the disk in a pixel of a blurred picture.
double share(int x, int y) { return 0.5 * std::erfc(beyond(x, y) / 1.5); }

double wrong_pixels(const Silhouette& a, const Silhouette& b) {
  double count = 0.0;
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    if (a.values()[i] != b.values()[i]) count += 1.0;
  }
  return count;
}

TEST(Border, MovesToHalfHeightFromEitherSideWhereLightFades) {
  Image<float> picture(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      // One threshold that is right on the left is wrong on the right.
      picture(x, y) = static_cast<float>((1.0 - 0.006 * x) * (20.0 + 100.0 * share(x, y)));
    }
  }
  for (const double larger : {-2.0, 2.0}) {
    Silhouette silhouette = disk(larger);
    ASSERT_GT(wrong_pixels(silhouette, disk(0.0)), 300.0);
    move_border_to_half_height(picture, 1.0, {}, silhouette);
    EXPECT_LT(wrong_pixels(silhouette, disk(0.0)), 30.0) << larger;
  }
}

TEST(Border, OfThreeChannelsItTakesTheOneThatTells) {
  Image<float> picture(kSize, kSize, 0.0F, 3);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      picture(x, y, 0) = x / 3 % 2 == 0 ? 200.0F : 0.0F;  // stripes on hand and background alike
      picture(x, y, 2) = static_cast<float>(30.0 * share(x, y));
    }
  }
  Silhouette silhouette = disk(2.0);
  move_border_to_half_height(picture, 1.0, {}, silhouette);
  EXPECT_LT(wrong_pixels(silhouette, disk(0.0)), 30.0);
}

TEST(Border, StaysWhereTheSidesDoNotDifferByMoreThanTheirSpread) {
  Image<float> picture(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) picture(x, y) = static_cast<float>(2.0 * share(x, y));
  }
  Silhouette silhouette = disk(2.0);
  move_border_to_half_height(picture, 1.0, {}, silhouette);
  EXPECT_EQ(silhouette, disk(2.0));
}

TEST(Border, LeavesUnknownPixelsAlone) {
  Image<float> picture(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) picture(x, y) = static_cast<float>(100.0 * share(x, y));
  }
  Silhouette silhouette = disk(2.0);
  for (int y = 0; y < kSize; ++y) silhouette(50, y) = PixelLabel::unknown;
  move_border_to_half_height(picture, 1.0, {}, silhouette);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::unknown), static_cast<std::size_t>(kSize));
}

TEST(Border, OfABallLitFromTheCameraIsWhereItEnds) {
  Image<float> picture(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double along = std::min(1.0, 1.0 + beyond(x, y) / 30.0);
      const double cosine = 0.2 + 0.8 * std::sqrt(std::max(0.0, 1.0 - along * along));
      picture(x, y) = static_cast<float>(5.0 + 200.0 * share(x, y) * cosine);
    }
  }
  const auto wrong = [&](Shading shading) {
    Silhouette silhouette = disk(-4.0);
    for (int move = 0; move < 3; ++move) {
      move_border_to_half_height(picture, 1.0, {.shading = shading}, silhouette);
    }
    return wrong_pixels(silhouette, disk(0.0));
  };
  EXPECT_LT(wrong(Shading::round), 120.0);  // of an outline of 190
  EXPECT_GT(wrong(Shading::even), 1.3 * wrong(Shading::round));
}

TEST(BorderContrast, IsThatOfTheEdgeAndNotOfAFadingLight) {
  Image<float> step(kSize, kSize), slope(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      step(x, y) = static_cast<float>(7.0 + 40.0 * share(x, y));
      slope(x, y) = static_cast<float>(-0.5 * beyond(x, y));
    }
  }
  const auto contrast = [](const Image<float>& picture, Silhouette silhouette) {
    return move_border_to_half_height(picture, 1.0, {}, silhouette).contrast;
  };
  EXPECT_NEAR(contrast(step, disk(0.0)), 40.0, 0.5);
  EXPECT_LT(contrast(slope, disk(0.0)), 1.0);  // from middle to corner it is 35
  EXPECT_EQ(contrast(step, Silhouette(kSize, kSize)), 0.0);
}

TEST(Border, RefusesAPictureOfAnotherSize) {
  Silhouette silhouette = disk(0.0);
  EXPECT_THROW(move_border_to_half_height(Image<float>(10, 10), 1.0, {}, silhouette), Error);
}

}  // namespace
}  // namespace tegata
