// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/evaluate/keypoint_error.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tegata/base/random.h"
#include "tegata/math/rigid3d.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

Keypoints some_keypoints(std::uint64_t seed = 1) {
  Random random(seed);
  Keypoints keypoints;
  for (auto& keypoint : keypoints) {
    keypoint = {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
  }
  return keypoints;
}

Keypoints moved(Keypoints keypoints, const Rigid3d& motion, double scale = 1.0) {
  for (auto& keypoint : keypoints) keypoint = motion * (scale * keypoint);
  return keypoints;
}

TEST(KeypointError, AShiftCountsOnlyInTheAbsoluteError) {
  const Keypoints truth = some_keypoints();
  const Keypoints fitted = moved(truth, {Eigen::Quaterniond::Identity(), {0.003, 0.0, -0.004}});
  EXPECT_NEAR(keypoint_error(fitted, truth), 0.005, 1e-12);
  EXPECT_NEAR(root_relative_keypoint_error(fitted, truth), 0.0, 1e-12);
  EXPECT_NEAR(procrustes_keypoint_error(fitted, truth), 0.0, 1e-12);
  EXPECT_NEAR(flexion_error(fitted, truth), 0.0, 1e-7);
}

TEST(KeypointError, ATurnAndAScaleDoNotCountAfterProcrustes) {
  const Keypoints truth = some_keypoints();
  const Keypoints fitted = moved(truth, {so3_exp({0.4, 2.0, -0.3}), {0.1, 0.2, 0.3}}, 1.3);
  EXPECT_GT(root_relative_keypoint_error(fitted, truth), 0.01);
  EXPECT_NEAR(procrustes_keypoint_error(fitted, truth), 0.0, 1e-12);
}

TEST(KeypointError, AMirroredHandIsNotAlignedAway) {
  const Keypoints truth = some_keypoints();
  Keypoints mirrored = truth;
  for (auto& keypoint : mirrored) keypoint.x() = -keypoint.x();
  EXPECT_GT(procrustes_keypoint_error(mirrored, truth), 0.01);
}

TEST(KeypointError, OneKeypointThatIsOffCountsATwentyFirst) {
  const Keypoints truth = some_keypoints();
  Keypoints fitted = truth;
  fitted[7].x() += 0.021;
  EXPECT_NEAR(keypoint_error(fitted, truth), 0.001, 1e-12);
  EXPECT_NEAR(root_relative_keypoint_error(fitted, truth), 0.001, 1e-12);
  fitted = truth;
  fitted[0].x() += 0.021;
  EXPECT_NEAR(root_relative_keypoint_error(fitted, truth), 0.020, 1e-12);
}

TEST(FlexionError, OneJointBentByThirtyDegreesIsTwo) {
  Keypoints straight;
  straight[0].setZero();
  for (std::size_t i = 0; i < 20; ++i) {
    straight[1 + i] = {0.02 * static_cast<double>(i / 4), 0.05 * static_cast<double>(1 + i % 4),
                       0.0};
  }
  // The thumb lies on the y axis, so all its angles are zero.
  EXPECT_NEAR(bone_angles(straight)[0], 0.0, 1e-12);
  Keypoints bent = straight;
  const Eigen::Quaterniond turn = so3_exp({std::numbers::pi / 6.0, 0.0, 0.0});
  for (std::size_t i = 3; i <= 4; ++i) bent[i] = bent[2] + turn * (straight[i] - straight[2]);
  EXPECT_NEAR(bone_angles(bent)[1], std::numbers::pi / 6.0, 1e-12);
  EXPECT_NEAR(flexion_error(bent, straight), std::numbers::pi / 6.0 / 15.0, 1e-12);
}

}  // namespace
}  // namespace tegata
