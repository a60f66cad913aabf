// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tegata/base/random.h"

namespace tegata {
namespace {

bool is_hand(PixelLabel label) { return label == PixelLabel::hand; }

float brute_force(const Silhouette& silhouette, int x, int y) {
  const bool inside = is_hand(silhouette(x, y));
  double nearest = std::numeric_limits<double>::infinity();
  for (int v = 0; v < silhouette.height(); ++v) {
    for (int u = 0; u < silhouette.width(); ++u) {
      if (is_hand(silhouette(u, v)) != inside)
        nearest = std::min(nearest, std::hypot(u - x, v - y));
    }
  }
  return static_cast<float>(inside ? nearest - 0.5 : 0.5 - nearest);
}

void expect_brute_force(const Silhouette& silhouette) {
  const Image<float> distance = signed_distance(silhouette, is_hand);
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      ASSERT_NEAR(distance(x, y), brute_force(silhouette, x, y), 1e-5) << x << ' ' << y;
    }
  }
}

TEST(SignedDistance, IsThatOfBruteForce) {
  Random random(7);
  for (const double share : {0.002, 0.05, 0.5, 0.95, 0.998}) {
    Silhouette silhouette(41, 29);
    for (PixelLabel& label : silhouette.values()) {
      if (random.uniform() < share) label = PixelLabel::hand;
    }
    silhouette(3, 4) = PixelLabel::hand;
    silhouette(30, 20) = PixelLabel::unknown;
    expect_brute_force(silhouette);
  }
}

TEST(SignedDistance, IsRightInPicturesOfOneRowOrColumn) {
  for (const auto& [width, height] : {std::pair(17, 1), std::pair(1, 17)}) {
    Silhouette silhouette(width, height);
    silhouette.values()[5] = PixelLabel::hand;
    expect_brute_force(silhouette);
  }
}

TEST(SignedDistance, PutsTheEdgeHalfWayBetweenPixels) {
  Silhouette silhouette(20, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 8; ++x) silhouette(x, y) = PixelLabel::hand;
  }
  const Image<float> distance = signed_distance(silhouette, is_hand);
  EXPECT_FLOAT_EQ(distance(7, 5), 0.5F);
  EXPECT_FLOAT_EQ(distance(8, 5), -0.5F);
  EXPECT_FLOAT_EQ(distance(12, 5), -4.5F);
  EXPECT_NEAR(sample_bilinear(distance, 7.5, 5.0), 0.0F, 1e-6);
}

TEST(SignedDistance, IsFarEverywhereWhereThereIsNoEdge) {
  const Silhouette nothing(30, 20);
  EXPECT_EQ(signed_distance(nothing, is_hand), Image<float>(30, 20, -50.0F));
  const Silhouette everything(30, 20, PixelLabel::hand);
  EXPECT_EQ(signed_distance(everything, is_hand), Image<float>(30, 20, 50.0F));
}

TEST(SignedDistance, AsksThePredicateForEveryLabel) {
  Silhouette silhouette(5, 1);
  silhouette(2, 0) = PixelLabel::unknown;
  const auto not_background = [](PixelLabel label) { return label != PixelLabel::background; };
  EXPECT_FLOAT_EQ(signed_distance(silhouette, not_background)(2, 0), 0.5F);
  EXPECT_FLOAT_EQ(signed_distance(silhouette, is_hand)(2, 0), -6.0F);
}

TEST(SampleBilinear, IsExactForALinearImageAndClampsOutside) {
  Image<float> image(6, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 6; ++x) image(x, y) = static_cast<float>(2 * x - 3 * y);
  }
  EXPECT_NEAR(sample_bilinear(image, 2.25, 3.5), 2 * 2.25 - 3 * 3.5, 1e-5);
  EXPECT_NEAR(sample_bilinear(image, 5.0, 4.0), -2.0, 1e-5);
  EXPECT_NEAR(sample_bilinear(image, -3.0, 2.0), -6.0, 1e-5);
  EXPECT_NEAR(sample_bilinear(image, 9.0, 11.0), -2.0, 1e-5);
}

}  // namespace
}  // namespace tegata
