// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/opensim_export.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/export/export_readers_for_tests.h"
#include "tegata/export/moving_result_for_tests.h"

namespace tegata {
namespace {

TEST(OpensimExport, TrcHasTheKeypointsAndEmptyCellsWithoutAPose) {
  const Result result = moving_result(moving_hand());
  expect_keypoints(trc_keypoints(trc_text(result)), result);
}

TEST(OpensimExport, TrcLinesAreAsLongAsTheirHeader) {
  const std::vector<std::string> lines = lines_of(trc_text(moving_result(moving_hand())));
  ASSERT_EQ(lines.size(), 6U + 8U);
  EXPECT_EQ(split(lines[1], '\t').size(), split(lines[2], '\t').size());
  EXPECT_EQ(split(lines[2], '\t')[0], "10.000000");  // frames a second
  EXPECT_EQ(split(lines[2], '\t')[2], "8");
  EXPECT_EQ(lines[5], "");
  for (std::size_t i = 6; i < lines.size(); ++i) {
    EXPECT_EQ(std::count(lines[i].begin(), lines[i].end(), '\t'), 1 + 3 * kKeypointCount);
  }
}

TEST(OpensimExport, MotHasPoseAndAnglesAndNotANumberWithoutThem) {
  for (const Side side : {Side::right, Side::left}) {
    const HandModel hand = moving_hand(side);
    const Result result = moving_result(hand);
    expect_keypoints(mot_keypoints(mot_text(result), hand.skeleton), result);
  }
}

TEST(OpensimExport, MotHeaderCountsRowsAndColumns) {
  const std::vector<std::string> lines = lines_of(mot_text(moving_result(moving_hand())));
  ASSERT_GT(lines.size(), 7U);
  EXPECT_EQ(lines[2], "nRows=8");
  EXPECT_EQ(lines[3], "nColumns=27");
  EXPECT_EQ(lines[4], "inDegrees=yes");
  EXPECT_EQ(lines[5], "endheader");
  ASSERT_EQ(lines.size(), 7U + 8U);
  for (std::size_t i = 6; i < lines.size(); ++i) EXPECT_EQ(split(lines[i], '\t').size(), 27U);
}

}  // namespace
}  // namespace tegata
