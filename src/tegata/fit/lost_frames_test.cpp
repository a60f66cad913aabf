// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/lost_frames.h"

#include <gtest/gtest.h>

#include "tegata/fit/support.h"
#include "tegata/fit/test_scene.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

struct LostScene {
  explicit LostScene(int count) {
    for (int f = 0; f < count; ++f) {
      truth.push_back(test::grasping_pose(0.2 * f));
      frames.push_back(
          test::perfect_frame(test::coarse_hand(), truth.back(), test::orthogonal_rig(0.8)));
    }
    for (const FitFrame& frame : frames) pointers.push_back(&frame);
  }

  std::vector<HandPose> truth;
  std::vector<FitFrame> frames;
  std::vector<const FitFrame*> pointers;
};

HandPose lost(HandPose pose) {
  pose.world_from_hand.rotation = so3_exp({0.0, 0.9, 0.4}) * pose.world_from_hand.rotation;
  pose.world_from_hand.translation += Eigen::Vector3d(0.03, -0.02, 0.02);
  return pose;
}

// Of these frames the first and the last find the hand backwards and forwards alone, the two in the
// middle one by the other; the camera that was thought to lie does not.
TEST(LostFrames, FindTheHandByTheirNeighbours) {
  const LostScene scene(9);
  const HandModel& hand = test::coarse_hand();
  std::vector<HandPose> poses = scene.truth;
  for (const std::size_t f : {0U, 3U, 4U, 8U}) poses[f] = lost(poses[f]);
  std::vector<std::vector<std::string>> left_out(poses.size());
  left_out[3] = {scene.frames[3].views[0].camera.name};
  const FitSchedule schedule = object_schedule();
  const TriangleMesh nothing;
  find_lost_frames(FitHand(hand), GivenFrames(scene.pointers),
                   {scene.truth.front().angles, nothing, schedule}, 1, poses, left_out);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    EXPECT_LT(test::mean_keypoint_distance(hand, poses[f], scene.truth[f]), 0.001) << f;
    EXPECT_TRUE(left_out[f].empty());
  }
}

// Beside the picture nothing of the seen hand lies on the side of the fitted fingers.
TEST(LostFrames, AViewThatTheHandIsBesideDoesNotPassForCovered) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.0);
  FitFrame frame = test::perfect_frame(hand, truth, test::orthogonal_rig(0.8));
  frame.views.resize(1);
  HandPose beside = truth;
  beside.world_from_hand.translation.y() += 0.6;
  const FitHand fit_hand(hand);
  EXPECT_LT(uncovered_in_most(fit_hand, frame, truth), 1e-4);
  EXPECT_DOUBLE_EQ(uncovered_in_most(fit_hand, frame, beside), kWhollyUncovered * fit_hand.scale);
}

TEST(LostFrames, FoundOnesAreNotTouched) {
  const LostScene scene(3);
  std::vector<HandPose> poses = scene.truth;
  poses[1].world_from_hand.translation.x() += 2e-4;
  const std::vector<HandPose> before = poses;
  std::vector<std::vector<std::string>> left_out(poses.size());
  left_out[2] = {"camera"};
  const FitSchedule schedule = object_schedule();
  const TriangleMesh nothing;
  find_lost_frames(FitHand(test::coarse_hand()), GivenFrames(scene.pointers),
                   {scene.truth.front().angles, nothing, schedule}, 1, poses, left_out);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    EXPECT_EQ(poses[f].world_from_hand.translation, before[f].world_from_hand.translation);
  }
  EXPECT_EQ(left_out[2].size(), 1U);
}

}  // namespace
}  // namespace tegata
