// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/pixel_box.h"

#include <gtest/gtest.h>

#include "tegata/image/silhouette.h"

namespace tegata {
namespace {

TEST(PixelBox, HasAllPixelsOfAValueUpToTheEdgesAndNoOthers) {
  Silhouette silhouette(9, 7);
  EXPECT_TRUE(bounds_of(silhouette, PixelLabel::hand).empty());
  silhouette(3, 5) = silhouette(8, 2) = PixelLabel::hand;
  silhouette(0, 6) = PixelLabel::unknown;
  PixelBox box = bounds_of(silhouette, PixelLabel::hand);
  EXPECT_EQ(box.left, 3);
  EXPECT_EQ(box.top, 2);
  EXPECT_EQ(box.right, 8);
  EXPECT_EQ(box.bottom, 5);
  box = bounds_of(silhouette, PixelLabel::unknown);
  EXPECT_EQ(box.width(), 1);
  EXPECT_EQ(box.height(), 1);
  EXPECT_EQ(box.left, 0);
  EXPECT_TRUE(bounds_of(Silhouette(), PixelLabel::background).empty());
}

}  // namespace
}  // namespace tegata
