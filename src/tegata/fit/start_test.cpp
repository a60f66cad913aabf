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

TEST(Start, OrientationsLeaveNoLargeGap) {
  TriangleMesh hull;
  hull.vertices = {Eigen::Vector3d::Zero()};
  const auto poses = poses_around(test::coarse_hand().skeleton, hull, 64);
  ASSERT_EQ(poses.size(), 64U);
  double widest = 0.0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Quaterniond query = so3_exp(3.0 * Eigen::Vector3d::Random());
    double nearest = 10.0;
    for (const Rigid3d& pose : poses) {
      nearest = std::min(nearest, pose.rotation.angularDistance(query));
    }
    widest = std::max(widest, nearest);
  }
  EXPECT_LT(widest, 1.2);
}

TEST(Start, TypicalAnglesAreWithinTheLimits) {
  for (const JointAngles& angles : typical_angles()) {
    EXPECT_TRUE((angles.array() >= angle_limits().lower.array()).all());
    EXPECT_TRUE((angles.array() <= angle_limits().upper.array()).all());
  }
}

TEST(Start, RefusesAnEmptyHull) {
  EXPECT_THROW(poses_around(test::coarse_hand().skeleton, {}, 4), Error);
}

}  // namespace
}  // namespace tegata
