// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/digit_search.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

struct Scene {
  std::vector<HandPose> truth;
  std::vector<FitFrame> frames;
  std::vector<const FitFrame*> pointers;
};

Scene turning_hand(int count) {
  Scene scene;
  for (int f = 0; f < count; ++f) {
    scene.truth.push_back(test::grasping_pose(0.3 * f));
    scene.frames.push_back(
        test::perfect_frame(test::coarse_hand(), scene.truth.back(), test::orthogonal_rig(0.8)));
  }
  for (const FitFrame& frame : scene.frames) scene.pointers.push_back(&frame);
  return scene;
}

HandEstimate estimate_of(const Scene& scene) {
  HandEstimate estimate{scene.truth.front().angles, {}};
  for (const HandPose& pose : scene.truth) estimate.world_from_hand.push_back(pose.world_from_hand);
  return estimate;
}

TEST(DigitSearch, AFingerInItsNeighboursPlaceFindsItsOwn) {
  const Scene scene = turning_hand(3);
  const FitHand hand(test::coarse_hand());
  HandEstimate stuck = estimate_of(scene);
  // The middle finger lies through the index finger, where small steps leave it.
  stuck.angles[8] = 0.5;
  HandEstimate settled = stuck;
  for (const FitStage& stage : grasp_schedule().stages) {
    minimise(hand, scene.pointers, stage, 0, settled);
  }
  const JointAngles& truth = scene.truth.front().angles;
  ASSERT_GT((settled.angles - truth).cwiseAbs().maxCoeff(), 0.25) << "no longer a trap";

  EXPECT_TRUE(reseat_digits(hand, scene.pointers, grasp_schedule(), 0, settled).has_value());
  EXPECT_LT((settled.angles - truth).cwiseAbs().maxCoeff(), 0.1);
  for (std::size_t f = 0; f < scene.truth.size(); ++f) {
    EXPECT_LT(test::mean_keypoint_distance(test::coarse_hand(), settled.pose(f), scene.truth[f]),
              0.002);
  }
}

TEST(DigitSearch, FingersInTheirPlaceStayThere) {
  const Scene scene = turning_hand(2);
  const FitHand hand(test::coarse_hand());
  HandEstimate before = estimate_of(scene);
  for (const FitStage& stage : grasp_schedule().stages) {
    minimise(hand, scene.pointers, stage, 0, before);
  }
  HandEstimate after = before;
  reseat_digits(hand, scene.pointers, grasp_schedule(), 0, after);
  // Two frames leave the last two joints of a finger some play against each other.
  EXPECT_LT((after.angles - before.angles).cwiseAbs().maxCoeff(), 0.2);
  for (std::size_t f = 0; f < scene.truth.size(); ++f) {
    EXPECT_LT(test::mean_keypoint_distance(test::coarse_hand(), after.pose(f), scene.truth[f]),
              0.002);
  }
}

}  // namespace
}  // namespace tegata
