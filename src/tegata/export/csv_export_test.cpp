// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/csv_export.h"

#include <gtest/gtest.h>

#include "tegata/export/export_readers_for_tests.h"
#include "tegata/export/moving_result_for_tests.h"

namespace tegata {
namespace {

TEST(CsvExport, HasTheKeypointsAndEmptyCellsWithoutAPose) {
  const Result result = moving_result(moving_hand());
  expect_keypoints(csv_keypoints(csv_text(result)), result);
}

TEST(CsvExport, PoseAndAnglesGiveTheKeypointsToo) {
  const HandModel hand = moving_hand();
  const Result result = moving_result(hand);
  std::vector<NamedPoints> frames;
  for (const auto& row : csv_rows(csv_text(result))) {
    NamedPoints& points = frames.emplace_back();
    if (row.at("hand_qw").empty()) continue;
    const auto number = [&row](const std::string& key) { return std::stod(row.at(key)); };
    HandPose pose;
    pose.world_from_hand = {
        {number("hand_qw"), number("hand_qx"), number("hand_qy"), number("hand_qz")},
        {number("hand_x_m"), number("hand_y_m"), number("hand_z_m")}};
    for (int i = 0; i < kAngleCount; ++i) {
      pose.angles[i] = number(std::string(angle_names()[static_cast<std::size_t>(i)]) + "_rad");
    }
    const auto keypoints = posed_keypoints(hand.skeleton, pose);
    for (std::size_t k = 0; k < keypoints.size(); ++k) {
      points[std::string(keypoint_names()[k])] = keypoints[k];
    }
  }
  expect_keypoints(frames, result);
}

TEST(CsvExport, NamesMayHoldCommasAndQuotes) {
  const auto rows = csv_rows(csv_text(moving_result(moving_hand())));
  ASSERT_EQ(rows.size(), 8U);
  EXPECT_EQ(rows[1].at("frame"), "b,1");
  EXPECT_EQ(rows[3].at("status"), "seen by 1 camera, \"2\" or more are needed");
  EXPECT_EQ(std::stod(rows[1].at("right, above_iou")), 0.5);
  EXPECT_EQ(std::stod(rows[1].at("index_middle_support")), 0.05 * 5.0);
  EXPECT_EQ(rows[3].at("left_iou"), "");
}

}  // namespace
}  // namespace tegata
