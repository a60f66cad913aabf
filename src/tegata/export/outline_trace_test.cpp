// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/outline_trace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tegata {
namespace {

Silhouette drawn(int width, int height, const auto& is_hand) {
  Silhouette silhouette(width, height, PixelLabel::background);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (is_hand(x, y)) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

double enclosed_area(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * twice;
}

TEST(OutlineTrace, DiskIsAFewPointsNearItsEdge) {
  const auto outlines = trace_outlines(
      drawn(60, 50, [](int x, int y) { return std::hypot(x - 30, y - 25) < 20.0; }), 0.6);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_LT(outlines[0].size(), 40u);
  for (const Eigen::Vector2d& point : outlines[0]) {
    EXPECT_NEAR((point - Eigen::Vector2d(30.0, 25.0)).norm(), 20.0, 1.0);
  }
  EXPECT_NEAR(enclosed_area(outlines[0]), 400.0 * 3.1416, 40.0);
}

TEST(OutlineTrace, HolesAndPiecesEachHaveALine) {
  const auto outlines = trace_outlines(drawn(40, 20,
                                             [](int x, int y) {
                                               const bool ring = x < 20 && y > 1 && y < 18 && x > 1;
                                               const bool hole = x > 6 && x < 14 && y > 6 && y < 13;
                                               return (ring && !hole) || x > 30;
                                             }),
                                       0.5);
  ASSERT_EQ(outlines.size(), 3u);
  double area = 0.0;
  for (const Outline& outline : outlines) area += enclosed_area(outline);
  EXPECT_NEAR(area, 18 * 16 - 7 * 6 + 9 * 20, 30.0);  // the hole's counts negative
}

TEST(OutlineTrace, PixelsThatTouchAtACornerDoNotCatchTheWalk) {
  const Silhouette board = drawn(12, 12, [](int x, int y) { return (x / 4 + y / 4) % 2 == 0; });
  const auto outlines = trace_outlines(board, 0.5);
  EXPECT_EQ(outlines.size(), 5u);
}

TEST(OutlineTrace, HandThatFillsThePictureAndEmptyOneEnd) {
  const auto full = trace_outlines(Silhouette(8, 6, PixelLabel::hand), 0.8);
  ASSERT_EQ(full.size(), 1u);
  EXPECT_NEAR(enclosed_area(full[0]), 48.0, 8.0);
  EXPECT_TRUE(trace_outlines(Silhouette(8, 6, PixelLabel::background), 0.5).empty());
  EXPECT_TRUE(
      trace_outlines(drawn(9, 9, [](int x, int y) { return x == 4 && y == 4; }), 0.5).empty());
}

}  // namespace
}  // namespace tegata
