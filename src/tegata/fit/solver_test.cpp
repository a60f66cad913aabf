// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/solver.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/fit/frame_fit.h"
#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// Off by about 8 degrees and 8 mm.
HandPose disturbed(HandPose pose, double scale = 1.0) {
  pose.world_from_hand.rotation = so3_exp({0.10, -0.08, 0.06}) * pose.world_from_hand.rotation;
  pose.world_from_hand.translation += scale * Eigen::Vector3d(0.005, -0.004, 0.005);
  for (int k = 0; k < kAngleCount; ++k) pose.angles[k] += (k % 2 == 0 ? 0.08 : -0.08);
  return pose;
}

TEST(Solver, ReturnsToTheTruthFromNearby) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  const HandPose truth = test::grasping_pose(0.3);
  const FitFrame frame = test::perfect_frame(hand, truth, test::orthogonal_rig(0.8));
  const FrameFit fit = fit_frame(fit_hand, frame, disturbed(truth), hull_first_schedule());
  EXPECT_LT(test::mean_keypoint_distance(hand, fit.pose, truth), 0.002);
  EXPECT_LT((fit.pose.angles - truth.angles).cwiseAbs().mean(), 0.08);
}

TEST(Solver, ASceneTenTimesAsLargeHasTheSameAnswer) {
  const HandModel& hand = test::coarse_hand();
  const HandModel large = scaled(hand, 10.0);
  const HandPose truth = test::grasping_pose(0.3), large_truth = test::grasping_pose(0.3, 10.0);
  const FitSchedule schedule{{hull_first_schedule().stages.back()}};
  const FrameFit fit =
      fit_frame(FitHand(hand), test::perfect_frame(hand, truth, test::orthogonal_rig(0.8)),
                disturbed(truth), schedule);
  const FrameFit large_fit =
      fit_frame(FitHand(large), test::perfect_frame(large, large_truth, test::orthogonal_rig(8.0)),
                disturbed(large_truth, 10.0), schedule);
  EXPECT_LT((fit.pose.angles - large_fit.pose.angles).norm(), 0.02);
  EXPECT_LT(
      (10.0 * fit.pose.world_from_hand.translation - large_fit.pose.world_from_hand.translation)
          .norm(),
      0.005);
}

// The farthest that ends from three starts lie apart in one angle.
double settling_gap(const FitHand& fit_hand, double scene_turn) {
  const HandPose truth = test::grasping_pose(scene_turn);
  const FitFrame frame = test::perfect_frame(*fit_hand.model, truth, test::orthogonal_rig(0.8));
  FitStage stage;
  stage.border = BorderTermOptions{.weight = 30.0};
  stage.most_iterations = 0;
  stage.settling_steps = 30;
  std::vector<JointAngles> ends;
  for (const double turn : {-0.0175, 0.0, 0.0175}) {  // a degree
    HandPose start = truth;
    for (int k = 0; k < kAngleCount; ++k) start.angles[k] += k % 2 == 0 ? turn : -turn;
    ends.push_back(fit_frame(fit_hand, frame, start, {{stage}}).pose.angles);
  }
  return std::max((ends[0] - ends[1]).cwiseAbs().maxCoeff(),
                  (ends[2] - ends[1]).cwiseAbs().maxCoeff());
}

// In a picture as small as this a border of a pixel or two may be another's from one start, so
// that a single scene tells little.
TEST(Solver, SettlesAtTheSamePlaceFromWhereverItBegins) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  std::vector<double> gaps;
  for (const double turn : {0.1, 0.2, 0.3, 0.4, 0.5}) gaps.push_back(settling_gap(fit_hand, turn));
  EXPECT_LT(median(gaps), 0.002);
  EXPECT_LT(*std::max_element(gaps.begin(), gaps.end()), 0.0175);
}

TEST(Solver, TheNumberOfThreadsChangesNoBit) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  std::vector<FitFrame> frames;
  HandEstimate start;
  for (const double turn : {0.0, 0.25, 0.5}) {
    const HandPose truth = test::grasping_pose(turn);
    frames.push_back(test::perfect_frame(hand, truth, test::orthogonal_rig(0.8)));
    start.world_from_hand.push_back(disturbed(truth).world_from_hand);
    start.angles = disturbed(truth).angles;
  }
  const std::vector<const FitFrame*> pointers = {&frames[0], &frames[1], &frames[2]};
  FitStage stage = grasp_schedule().stages.back();
  stage.most_iterations = 3;
  HandEstimate with_one = start, with_three = start;
  minimise(fit_hand, pointers, stage, 1, with_one);
  minimise(fit_hand, pointers, stage, 3, with_three);
  EXPECT_EQ(with_one.angles, with_three.angles);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_EQ(with_one.world_from_hand[f].translation, with_three.world_from_hand[f].translation);
    EXPECT_EQ(with_one.world_from_hand[f].rotation.coeffs(),
              with_three.world_from_hand[f].rotation.coeffs());
  }
}

TEST(Solver, NoEvidenceKeepsThePose) {
  const FitHand fit_hand(test::coarse_hand());
  const FitFrame nothing;
  const FitFrame* const frames[] = {&nothing};
  const HandPose start = test::grasping_pose(0.1);
  HandEstimate estimate{start.angles, {start.world_from_hand}};
  minimise(fit_hand, frames, FitStage{}, 1, estimate);
  EXPECT_LT((estimate.world_from_hand[0].translation - start.world_from_hand.translation).norm(),
            1e-9);
  EXPECT_TRUE(estimate.angles.allFinite());
}

TEST(Solver, StopsAtItsLimitAndSaysSo) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.3);
  const FitFrame frame = test::perfect_frame(hand, truth, test::orthogonal_rig(0.8));
  FitStage stage = hull_first_schedule().stages.front();
  stage.most_iterations = 1;
  const FrameFit fit = fit_frame(FitHand(hand), frame, disturbed(truth), {{stage}});
  EXPECT_EQ(fit.report.iterations, 1);
  EXPECT_EQ(fit.report.termination, Termination::iteration_limit);
}

}  // namespace
}  // namespace tegata
