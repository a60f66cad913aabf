// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/exported_frames.h"

#include <gtest/gtest.h>

#include "tegata/base/angle.h"
#include "tegata/base/random.h"
#include "tegata/export/moving_result_for_tests.h"
#include "tegata/math/so3.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

Eigen::Quaterniond from_zyx(const Eigen::Vector3d& angles) {
  return Eigen::AngleAxisd(angles[0], Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles[1], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles[2], Eigen::Vector3d::UnitX());
}

TEST(ZyxAngles, GiveBackAnyRotation) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3d angles;
    for (int j = 0; j < 3; ++j) angles[j] = random.uniform(-3.1, 3.1);
    // With a quarter turn about y, the other two are one.
    if (i % 4 == 0) angles[1] = (i % 8 == 0 ? 90.0 : -90.0) * kDegree;
    const Eigen::Quaterniond rotation = from_zyx(angles);
    const Eigen::Vector3d got = zyx_angles(rotation, Eigen::Vector3d::Zero());
    EXPECT_LT(rotation.angularDistance(from_zyx(got)), 1e-7) << angles.transpose();
  }
}

TEST(ZyxAngles, FollowAMovementWithoutJumps) {
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (int i = 0; i <= 720; i += 5) {
    const Eigen::Vector3d expected = Eigen::Vector3d(2.0, 0.1, -1.0) * i * kDegree;
    const Eigen::Vector3d got = zyx_angles(from_zyx(expected), before);
    EXPECT_LT((got - expected).norm(), 1e-6) << i;
    before = got;
  }
}

TEST(ExportedFrames, FrameWithoutPoseHoldsTheOneBefore) {
  const Result result = moving_result(moving_hand());
  const std::vector<const HandPose*> poses = held_poses(result);
  ASSERT_FALSE(result.frames[0].pose || result.frames[3].pose);
  EXPECT_EQ(poses[0], &*result.frames[1].pose);
  EXPECT_EQ(poses[3], &*result.frames[2].pose);
  EXPECT_EQ(poses[4], &*result.frames[4].pose);
}

TEST(ExportedFrames, ResultWithoutAnyPoseIsRefused) {
  Result result = moving_result(moving_hand());
  for (ResultFrame& frame : result.frames) frame.pose.reset();
  EXPECT_TRUE(says(error_of([&] { held_poses(result); }), "no frame has a pose"));
}

TEST(ExportedFrames, AnotherHandIsRefused) {
  const HandModel hand = moving_hand();
  const Result result = moving_result(hand);
  EXPECT_NO_THROW(check_fitted_hand(result, hand));
  HandModel longer = hand;
  for (Eigen::Vector3d& keypoint : longer.skeleton.keypoints) keypoint *= 1.02;
  EXPECT_TRUE(says(error_of([&] { check_fitted_hand(result, longer); }), "mm", "b,1"));
  EXPECT_TRUE(says(error_of([&] { check_fitted_hand(result, mirrored(hand)); }), "left", "right"));
}

TEST(ExportedFrames, DecimalHasNoNegativeZero) {
  EXPECT_EQ(decimal(-0.0004, 3), "0.000");
  EXPECT_EQ(decimal(-0.0006, 3), "-0.001");
  EXPECT_EQ(decimal(12.5, 1), "12.5");
}

}  // namespace
}  // namespace tegata
