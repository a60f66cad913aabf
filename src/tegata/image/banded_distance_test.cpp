// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/banded_distance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/image/distance_transform.h"

namespace tegata {
namespace {

// Compares with the exact transform.
void expect_limited_exact(const Image<std::uint8_t>& mask, int band) {
  Silhouette silhouette(mask.width(), mask.height());
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    silhouette.values()[i] = mask.values()[i] != 0 ? PixelLabel::hand : PixelLabel::background;
  }
  const Image<float> exact =
      signed_distance(silhouette, [](PixelLabel label) { return label == PixelLabel::hand; });
  const Image<float> banded = banded_distance(mask, band);
  for (const InstructionSet set : kInstructionSets) {
    ASSERT_TRUE(!is_supported(set) || banded_distance(mask, band, set) == banded);
  }
  const auto limit = static_cast<float>(band);
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      ASSERT_NEAR(banded(x, y), std::clamp(exact(x, y), -limit, limit), 1e-5f) << x << ", " << y;
    }
  }
}

TEST(BandedDistance, IsTheExactDistanceUpToTheBand) {
  Random random(5);
  for (const int band : {1, 2, 7, 40, kMostBand}) {
    Image<std::uint8_t> mask(97, 61, 0);
    for (int spot = 0; spot < 12; ++spot) {
      const int x0 = static_cast<int>(random.index(90)), y0 = static_cast<int>(random.index(55));
      const int side = 1 + static_cast<int>(random.index(12));
      for (int y = y0; y < std::min(mask.height(), y0 + side); ++y) {
        for (int x = x0; x < std::min(mask.width(), x0 + side); ++x) {
          mask(x, y) = spot % 4 == 0 ? 0 : 128;
        }
      }
    }
    expect_limited_exact(mask, band);
  }
}

TEST(BandedDistance, NothingAndEverythingAreFar) {
  expect_limited_exact(Image<std::uint8_t>(30, 20, 0), 9);
  expect_limited_exact(Image<std::uint8_t>(30, 20, 255), 9);
  expect_limited_exact(Image<std::uint8_t>(1, 1, 255), 1);
}

TEST(BandedDistance, RefusesBandsThatDoNotFit) {
  EXPECT_THROW(banded_distance(Image<std::uint8_t>(4, 4, 0), 0), Error);
  EXPECT_THROW(banded_distance(Image<std::uint8_t>(4, 4, 0), kMostBand + 1), Error);
}

}  // namespace
}  // namespace tegata
