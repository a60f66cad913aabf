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

TEST(Silhouette, CountsEachLabel) {
  Silhouette silhouette(4, 3);
  silhouette(1, 1) = kHand;
  silhouette(2, 1) = kHand;
  silhouette(3, 2) = kUnknown;
  EXPECT_EQ(count_pixels(silhouette, kHand), 2U);
  EXPECT_EQ(count_pixels(silhouette, kUnknown), 1U);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::background), 9U);
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
