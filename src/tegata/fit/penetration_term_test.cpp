// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/penetration_term.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

constexpr int kIndexAbduction = 4, kMiddleAbduction = 8;

FrameEquations penetration(const HandModel& hand, const JointAngles& angles, double scale = 1.0) {
  FrameEquations equations;
  add_penetration_term(hand.skeleton, DigitCapsules(hand), angles, {}, scale, 1.0, equations);
  return equations;
}

JointAngles crossed_fingers() {
  JointAngles angles = relaxed_angles();
  angles[kIndexAbduction] = -0.25;
  angles[kMiddleAbduction] = 0.1;
  return angles;
}

TEST(PenetrationTerm, TypicalPosesAreFree) {
  const HandModel& hand = test::coarse_hand();
  for (const JointAngles& angles :
       {JointAngles(JointAngles::Zero()), relaxed_angles(), test::grasping_pose(0.0).angles}) {
    EXPECT_EQ(penetration(hand, angles).cost, 0.0) << angles.transpose();
  }
}

TEST(PenetrationTerm, FingersThroughEachOtherCostAndThePoseDoesNot) {
  const FrameEquations equations = penetration(test::coarse_hand(), crossed_fingers());
  EXPECT_GT(equations.cost, 5.0);
  EXPECT_TRUE(equations.gradient.head<kPoseParameterCount>().isZero(0.0));
}

TEST(PenetrationTerm, GradientIsTheFiniteDifferenceOfTheCost) {
  const HandModel& hand = test::coarse_hand();
  const JointAngles angles = crossed_fingers();
  const auto cost = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, penetration(hand, angles + step).cost);
  };
  const Eigen::MatrixXd expected = finite_difference_jacobian(cost, JointAngles::Zero());
  const FrameEquations equations = penetration(hand, angles);
  EXPECT_LT((equations.gradient.tail<kAngleCount>().transpose() - expected).norm(),
            1e-5 * expected.norm());
}

TEST(PenetrationTerm, IsTheSameInAnotherUnit) {
  const HandModel& hand = test::coarse_hand();
  EXPECT_NEAR(penetration(scaled(hand, 10.0), crossed_fingers(), 10.0).cost,
              penetration(hand, crossed_fingers()).cost, 1e-6);
}

TEST(DigitCapsules, AreAsThickAsTheFingers) {
  const DigitCapsules capsules(test::coarse_hand());
  for (int bone = 4; bone < kBoneCount; ++bone) {
    EXPECT_GT(capsules.radius(bone), 0.005) << bone;
    EXPECT_LT(capsules.radius(bone), 0.013) << bone;
  }
}

}  // namespace
}  // namespace tegata
