// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/bvh_export.h"

#include <gtest/gtest.h>

#include "tegata/export/export_readers_for_tests.h"
#include "tegata/export/moving_result_for_tests.h"

namespace tegata {
namespace {

TEST(BvhExport, PutsTheKeypointsWhereTheResultDoes) {
  for (const Side side : {Side::right, Side::left}) {
    const HandModel hand = moving_hand(side);
    Result result = moving_result(hand);
    std::vector<NamedPoints> frames = bvh_keypoints(bvh_text(result, hand));
    ASSERT_EQ(frames.size(), result.frames.size());
    EXPECT_EQ(frames[3], frames[2]);  // held
    EXPECT_EQ(frames[0], frames[1]);
    frames[0].clear();
    frames[3].clear();
    expect_keypoints(frames, result);
  }
}

TEST(BvhExport, RestIsTheFlatHandInCentimetres) {
  const HandModel hand = moving_hand();
  std::string text = bvh_text(moving_result(hand), hand);
  const std::size_t motion = text.find("MOTION");
  std::string still = text.substr(0, motion) + "MOTION\nFrames: 1\nFrame Time: 0.1\n";
  for (int i = 0; i < 6 + 3 * 15; ++i) still += "0 ";
  const NamedPoints points = bvh_keypoints(still).front();
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    const Eigen::Vector3d got = y_down(points.at(std::string(keypoint_names()[k])));
    EXPECT_LT((got - hand.skeleton.keypoints[k]).norm(), 1e-7) << keypoint_names()[k];
  }
}

TEST(BvhExport, FramesComeAtTheirRate) {
  const HandModel hand = moving_hand();
  EXPECT_NE(bvh_text(moving_result(hand), hand).find("Frames: 8\nFrame Time: 0.100000000\n"),
            std::string::npos);
}

}  // namespace
}  // namespace tegata
