// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/start.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

TEST(Start, LandmarksGiveBackThePose) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.7);
  const auto keypoints = posed_keypoints(hand.skeleton, truth);
  const Rigid3d found =
      pose_from_landmarks(hand.skeleton, {keypoints[0], keypoints[5], keypoints[17]});
  EXPECT_LT(found.rotation.angularDistance(truth.world_from_hand.rotation), 1e-6);
  EXPECT_LT((found.translation - truth.world_from_hand.translation).norm(), 1e-6);
}

TEST(Start, TheHandIsTheEndThatNoPictureCutsOff) {
  // A rod along x that leaves the first camera's picture on the right.
  TriangleMesh rod;
  for (int i = 0; i <= 200; ++i) {
    rod.vertices.emplace_back(-0.1 + 0.002 * i, 0.0, 0.0);
    rod.normals.emplace_back(0.0, 1.0, 0.0);
  }
  FitFrame frame;
  frame.hull.emplace(rod);
  const Camera camera = test::orthogonal_rig(0.8)[0];
  frame.views.push_back(make_fit_view(camera, Silhouette(camera.width, camera.height)));
  const FitHand hand(test::coarse_hand());
  const std::vector<HullEnd> ends = hand_ends(hand, frame);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_LT((ends[0].tip - Eigen::Vector3d(-0.1, 0.0, 0.0)).norm(), 1e-6);
  EXPECT_LT((ends[0].direction - Eigen::Vector3d(-1.0, 0.0, 0.0)).norm(), 1e-3);
}

TEST(Start, AHullThatEndsUnprovenAtAPicturesEdgeIsCutOffThere) {
  // As above, but where the hull leaves the picture no silhouette shapes it.
  TriangleMesh rod;
  for (int i = 0; i <= 200; ++i) {
    rod.vertices.emplace_back(-0.1 + 0.002 * i, 0.0, 0.0);
    rod.normals.emplace_back(0.0, 1.0, 0.0);
    rod.unproven.push_back(i > 100 ? 1 : 0);
  }
  FitFrame frame;
  frame.hull.emplace(rod);
  const Camera camera = test::orthogonal_rig(0.8)[0];
  frame.views.push_back(make_fit_view(camera, Silhouette(camera.width, camera.height)));
  const std::vector<HullEnd> ends = hand_ends(FitHand(test::coarse_hand()), frame);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_LT((ends[0].tip - Eigen::Vector3d(-0.1, 0.0, 0.0)).norm(), 1e-6);
}

TEST(Start, BothEndsArePossibleWhereNothingIsCutOff) {
  const HandModel& hand = test::coarse_hand();
  const FitFrame frame = test::perfect_frame(hand, test::grasping_pose(0.0), {});
  EXPECT_EQ(hand_ends(FitHand(hand), frame).size(), 2U);
}

TEST(Start, OnePoseAtTheEndsIsNearTheTruth) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  const HandPose truth = test::grasping_pose(0.9);
  const FitFrame frame = test::perfect_frame(hand, truth, {});
  double nearest = 10.0;
  for (const Rigid3d& pose : poses_at_ends(fit_hand, hand_ends(fit_hand, frame))) {
    nearest = std::min(nearest, pose.rotation.angularDistance(truth.world_from_hand.rotation));
  }
  EXPECT_LT(nearest, 0.6);
}

TEST(Start, TypicalAnglesAreWithinTheLimits) {
  for (const JointAngles& angles : typical_angles()) {
    EXPECT_TRUE((angles.array() >= angle_limits().lower.array()).all());
    EXPECT_TRUE((angles.array() <= angle_limits().upper.array()).all());
  }
}

TEST(Start, RefusesAFrameWithoutAHull) {
  EXPECT_THROW(hand_ends(FitHand(test::coarse_hand()), FitFrame{}), Error);
}

}  // namespace
}  // namespace tegata
