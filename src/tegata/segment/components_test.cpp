// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/components.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

void fill(Silhouette& silhouette, int x0, int y0, int width, int height, PixelLabel label) {
  for (int y = y0; y < y0 + height; ++y) {
    for (int x = x0; x < x0 + width; ++x) silhouette(x, y) = label;
  }
}

Silhouette three_pieces() {
  Silhouette silhouette(60, 40);
  fill(silhouette, 2, 2, 20, 20, PixelLabel::hand);    // 400 pixels
  fill(silhouette, 30, 2, 10, 10, PixelLabel::hand);   // 100
  fill(silhouette, 50, 30, 2, 2, PixelLabel::hand);    // 4
  fill(silhouette, 0, 30, 5, 5, PixelLabel::unknown);  // none of a hand's business
  return silhouette;
}

TEST(Components, SmallPiecesGoByTheirShareOfTheLargest) {
  Silhouette silhouette = three_pieces();
  keep_large_components(silhouette, 0.1);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::hand), 500U);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::unknown), 25U);
  keep_large_components(silhouette, 0.3);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::hand), 400U);
}

TEST(Components, AShareOfOneKeepsASinglePieceOfTwoEqualOnes) {
  Silhouette silhouette(30, 10);
  fill(silhouette, 1, 1, 5, 5, PixelLabel::hand);
  fill(silhouette, 20, 1, 5, 5, PixelLabel::hand);
  keep_large_components(silhouette, 1.0);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::hand), 25U);
}

TEST(Components, PiecesHoldTogetherOverCorners) {
  Silhouette silhouette(30, 30);
  fill(silhouette, 1, 1, 10, 10, PixelLabel::hand);
  fill(silhouette, 11, 11, 3, 3, PixelLabel::hand);
  keep_large_components(silhouette, 1.0);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::hand), 109U);
}

TEST(Components, WithoutAHandNothingChanges) {
  Silhouette silhouette(10, 10);
  keep_large_components(silhouette, 0.5);
  fill_pinholes(silhouette, 30);
  EXPECT_EQ(silhouette, Silhouette(10, 10));
}

TEST(Components, PinholesAreFilledButNotHolesNorBays) {
  Silhouette silhouette(40, 40, PixelLabel::hand);
  fill(silhouette, 5, 5, 5, 6, PixelLabel::background);    // 30 pixels
  fill(silhouette, 20, 20, 6, 6, PixelLabel::background);  // 36
  fill(silhouette, 0, 30, 3, 3, PixelLabel::background);   // open to the edge of the picture
  fill_pinholes(silhouette, 30);
  EXPECT_EQ(silhouette(6, 6), PixelLabel::hand);
  EXPECT_EQ(silhouette(22, 22), PixelLabel::background);
  EXPECT_EQ(silhouette(1, 31), PixelLabel::background);
}

}  // namespace
}  // namespace tegata
