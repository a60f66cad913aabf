// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/fit_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tegata/base/text.h"

namespace tegata {
namespace {

Result good_result(std::size_t frame_count) {
  Result result;
  for (std::size_t i = 0; i < frame_count; ++i) {
    ResultFrame& frame = result.frames.emplace_back();
    frame.name = text("f", i);
    frame.time = 0.1 * static_cast<double>(i);
    frame.pose.emplace();
    frame.keypoints.fill(Eigen::Vector3d::Zero());
    frame.support.fill(0.8);
    frame.views = {"left", "right", "top"};
    frame.silhouette_iou = {{"left", 0.9}, {"right", 0.92}, {"top", 0.94}};
  }
  return result;
}

void lose(ResultFrame& frame) {
  frame.pose.reset();
  frame.status = "pictures from 1 camera";
  frame.silhouette_iou.clear();
}

TEST(FitSummary, GoodResultIsTwoLines) {
  const std::string summary = fit_summary(good_result(12));
  EXPECT_TRUE(summary.starts_with("good: 12 of 12 frames")) << summary;
  EXPECT_NE(summary.find("left 0.90, right 0.92, top 0.94"), std::string::npos) << summary;
  EXPECT_EQ(std::count(summary.begin(), summary.end(), '\n'), 2) << summary;
}

TEST(FitSummary, NamesTheFramesNotToTrustAndWhy) {
  Result result = good_result(20);
  for (const std::size_t i : {3U, 4U, 5U}) lose(result.frames[i]);
  result.frames[11].silhouette_iou["left"] = 0.3;
  const std::string summary = fit_summary(result);
  EXPECT_NE(summary.find("f3 to f5: no pose: pictures from 1 camera\n"), std::string::npos)
      << summary;
  EXPECT_NE(summary.find("f11: overlap in left 0.30"), std::string::npos) << summary;
  EXPECT_NE(summary.find("16 of 20"), std::string::npos) << summary;
}

TEST(FitSummary, StaysShortHoweverMuchIsWrong) {
  Result result = good_result(60);
  for (std::size_t i = 0; i < 60; i += 2) lose(result.frames[i]);
  result.grasp_standard_deviations.setConstant(0.2);
  for (ResultFrame& frame : result.frames) frame.support.fill(0.0);
  const std::string summary = fit_summary(result);
  EXPECT_LE(std::count(summary.begin(), summary.end(), '\n'), 12) << summary;
  EXPECT_NE(summary.find("and 25 more"), std::string::npos) << summary;
  EXPECT_TRUE(summary.starts_with("poor: ")) << summary;
}

TEST(FitSummary, WarnsOfAStartThatHardlyLeads) {
  Result result = good_result(12);
  for (const double lead : {1.5, std::numeric_limits<double>::infinity()}) {
    result.start = {"f4", lead};
    EXPECT_EQ(fit_summary(result).find("unsure start"), std::string::npos) << lead;
  }
  result.start = {"f4", 1.04};
  const std::string summary = fit_summary(result);
  EXPECT_NE(summary.find("unsure start: in frame f4 a pose elsewhere has only 1.04 times"),
            std::string::npos)
      << summary;
}

TEST(FitSummary, NamesUnsureAnglesAndUnseenBones) {
  Result result = good_result(12);
  result.grasp_standard_deviations[15] = 0.2;
  for (ResultFrame& frame : result.frames) frame.support[12] = 0.02;
  const std::string summary = fit_summary(result);
  EXPECT_NE(summary.find("least sure: ring_dip_flexion by 11 deg\n"), std::string::npos) << summary;
  EXPECT_NE(summary.find("guessed: ring_distal\n"), std::string::npos) << summary;
}

}  // namespace
}  // namespace tegata
