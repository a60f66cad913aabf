// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/paper_fit.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/fit/test_scene.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

HandPose displaced(HandPose pose, double metres, double turn, double bend) {
  pose.world_from_hand.translation += metres * Eigen::Vector3d(1.0, -1.0, 1.0).normalized();
  pose.world_from_hand.rotation = so3_exp({0.0, turn, 0.0}) * pose.world_from_hand.rotation;
  for (int digit = 0; digit < kDigitCount; ++digit) pose.angles[4 * digit + 1] -= bend;
  return pose;
}

StartLandmarks landmarks_of(const HandModel& hand, const HandPose& pose) {
  const auto keypoints = posed_keypoints(hand.skeleton, pose);
  return {keypoints[0], keypoints[5], keypoints[17]};
}

// Hands that turn, their very surfaces for hulls, the first with landmarks that are a little off.
struct PaperScene {
  explicit PaperScene(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      truth.push_back(test::grasping_pose(0.15 * static_cast<double>(k)));
    }
    for (std::size_t k = 0; k < count; ++k) {
      FitFrame known;
      if (k == 0) known.landmarks = landmarks_of(hand, displaced(truth[0], 0.006, 0.08, 0.0));
      frames.emplace_back(std::make_shared<const FitFrame>(known),
                          PosedHand(hand, truth[k]).surface());
    }
  }
  // Of few triangles, which keeps the tests short under the sanitizers.
  const HandModel hand = built_in_hand(HandShape{}, Side::right, {.triangle_count = 600});
  FitHand fit_hand{hand};
  std::vector<HandPose> truth;
  std::vector<PaperFrame> frames;
};

// Fewer alternations than a fit has: what these tests ask does not need the last of them.
PaperFitOptions short_options(int threads = 0) {
  PaperFitOptions options;
  options.most_alternations = 3;
  options.threads = threads;
  return options;
}

TEST(PaperEnergy, SlopesAreThoseOfTheEnergy) {
  const PaperScene scene(1);
  const HandPose pose = displaced(scene.truth[0], 0.004, 0.06, 0.1);
  const PaperEnergy energy{scene.fit_hand, scene.frames[0], 0.01};
  const auto by_pose = [&](const Eigen::VectorXd& step) {
    return Eigen::VectorXd::Constant(1, energy.by_pose(energy.moved(pose, step)).energy);
  };
  const auto by_angles = [&](const Eigen::VectorXd& angles) {
    return Eigen::VectorXd::Constant(1, energy.by_angles({pose.world_from_hand, angles}).energy);
  };
  const Eigen::VectorXd of_pose = energy.by_pose(pose).gradient;
  const Eigen::VectorXd of_angles = energy.by_angles(pose).gradient;
  EXPECT_GT(of_pose.norm(), 1e-6);
  EXPECT_GT(of_angles.norm(), 1e-6);
  EXPECT_LT(
      (finite_difference_jacobian(by_pose, Eigen::VectorXd::Zero(6)).transpose() - of_pose).norm(),
      1e-3 * of_pose.norm());
  EXPECT_LT((finite_difference_jacobian(by_angles, pose.angles).transpose() - of_angles).norm(),
            1e-3 * of_angles.norm());
}

TEST(PaperFit, FindsASlightlyDisplacedHandAgain) {
  const PaperScene scene(1);
  const PaperFit fit = fit_paper(scene.fit_hand, scene.frames, short_options(), {});
  EXPECT_LT(test::mean_keypoint_distance(scene.hand, fit.poses[0], scene.truth[0]), 0.004);
  for (const double weight : fit.weights[0]) EXPECT_GT(weight, 0.7);
}

TEST(PaperFit, AllFramesShareOneSetOfAngles) {
  const PaperScene scene(2);
  const PaperFit fit = fit_paper(scene.fit_hand, scene.frames, short_options(), {});
  ASSERT_EQ(fit.poses.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(fit.poses[k].angles, fit.angles);
    EXPECT_LT(test::mean_keypoint_distance(scene.hand, fit.poses[k], scene.truth[k]), 0.004);
  }
  PaperFitOptions free = short_options();
  free.grasp = GraspConstraint::free;
  const PaperFit single = fit_paper(scene.fit_hand, scene.frames, free, {});
  EXPECT_NE(single.poses[0].angles, single.poses[1].angles);
  EXPECT_EQ(single.poses[1].angles, fit.single_poses[1].angles);
}

TEST(PaperFit, DoesNotDependOnTheNumberOfThreads) {
  const PaperScene scene(2);
  const PaperFit a = fit_paper(scene.fit_hand, scene.frames, short_options(1), {});
  const PaperFit b = fit_paper(scene.fit_hand, scene.frames, short_options(2), {});
  EXPECT_EQ(a.angles, b.angles);
  EXPECT_EQ(a.poses[1].world_from_hand.translation, b.poses[1].world_from_hand.translation);
}

TEST(PaperFit, StaysWithinTheJointLimits) {
  const PaperScene scene(1);
  const PaperFit fit = fit_paper(scene.fit_hand, scene.frames, short_options(), {});
  for (const HandPose& pose : fit.single_poses) {
    EXPECT_TRUE((pose.angles.array() <= angle_limits().upper.array()).all());
    EXPECT_TRUE((pose.angles.array() >= angle_limits().lower.array()).all());
  }
}

TEST(PaperFit, RefusesNoFrames) {
  const PaperScene scene(1);
  EXPECT_THROW(fit_paper(scene.fit_hand, {}, {}, {}), Error);
}

}  // namespace
}  // namespace tegata
