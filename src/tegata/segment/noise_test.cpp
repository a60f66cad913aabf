// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/noise.h"

#include <gtest/gtest.h>

#include "tegata/base/random.h"

namespace tegata {
namespace {

TEST(PixelNoise, IsMeasuredDespiteSlopesAndEdges) {
  Random random(1);
  for (const double noise : {0.5, 3.0, 40.0}) {
    Image<float> image(120, 100);
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 120; ++x) {
        const double edges = x / 30 % 2 == 0 ? 500.0 : 0.0;
        image(x, y) = static_cast<float>(2.0 * x - 3.0 * y + edges + random.normal(0.0, noise));
      }
    }
    EXPECT_NEAR(pixel_noise(image), noise, 0.1 * noise);
  }
}

TEST(PixelNoise, IsZeroForASmoothOrTinyImage) {
  EXPECT_EQ(pixel_noise(Image<float>(20, 20, 7.0F)), 0.0);
  EXPECT_EQ(pixel_noise(Image<float>(2, 50, 7.0F)), 0.0);
}

TEST(Median, IsTheMiddleValue) {
  EXPECT_EQ(median({5.0F, -1.0F, 100.0F}), 5.0F);
  EXPECT_EQ(median({2.0F}), 2.0F);
}

}  // namespace
}  // namespace tegata
