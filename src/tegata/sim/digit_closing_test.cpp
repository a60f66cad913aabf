// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/digit_closing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tegata/sim/sim_test_hand.h"

namespace tegata {
namespace {

constexpr int kMiddle = 2, kIndex = 1;

// A rod across the fingers, under the middle of their first bones.
PlacedObject rod_under_fingers() {
  const HandModel& hand = sim_test_hand();
  PlacedObject rod;
  rod.object = {HeldObject::Shape::cylinder, {0.02, 0.02, 0.06}};
  rod.hand_from_object.rotation =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX());
  rod.hand_from_object.translation =
      0.5 * (hand.skeleton.keypoints[9] + hand.skeleton.keypoints[10]) -
      Eigen::Vector3d(0.0, 0.0, 0.034);
  return rod;
}

DigitGoal curled() {
  DigitGoal goal;
  goal.preferred = Eigen::Vector4d(0.0, 0.8, 1.0, 0.6);
  return goal;
}

TEST(DigitClosing, ClearancesAreThoseOfTheSkinnedSurface) {
  const HandModel& hand = sim_test_hand();
  const PlacedObject rod = rod_under_fingers();
  const JointAngles angles = relaxed_angles();
  const PosedHand posed(hand, HandPose{{}, angles});
  std::array<double, 2> expected = {1.0, 1.0};
  for (std::size_t i = 0; i < hand.links.size(); ++i) {
    const int bone = main_bone(hand.links[i]) - (1 + 3 * kMiddle);
    if (bone != 1 && bone != 2) continue;
    double& least = expected[static_cast<std::size_t>(bone - 1)];
    least = std::min(least, rod.distance(posed.vertices()[i]));
  }
  const auto clearances = DigitSurface(hand, kMiddle).clearances(angles, rod);
  EXPECT_NEAR(clearances[1], expected[0], 1e-9);
  EXPECT_NEAR(clearances[2], expected[1], 1e-9);
}

TEST(DigitClosing, FingerWrapsARodAndNeitherMissesNorPiercesIt) {
  const HandModel& hand = sim_test_hand();
  const PlacedObject rod = rod_under_fingers();
  const DigitSurface finger(hand, kMiddle);
  const JointAngles angles = closed_digit(hand, finger, {}, curled(), rod, JointAngles::Zero());
  for (const double clearance : finger.clearances(angles, rod)) {
    EXPECT_GT(clearance, -0.002);
    EXPECT_LT(clearance, 0.004);
  }
  EXPECT_TRUE((angles.array() <= angle_limits().upper.array()).all());
  EXPECT_TRUE((angles.array() >= angle_limits().lower.array()).all());
}

TEST(DigitClosing, OtherDigitsStayAsTheyAre) {
  const HandModel& hand = sim_test_hand();
  const JointAngles before = relaxed_angles();
  const JointAngles after =
      closed_digit(hand, DigitSurface(hand, kMiddle), {}, curled(), rod_under_fingers(), before);
  EXPECT_NE(before.segment<4>(8), after.segment<4>(8));
  EXPECT_EQ(before.head<8>(), after.head<8>());
  EXPECT_EQ(before.tail<8>(), after.tail<8>());
}

TEST(DigitClosing, FingerDoesNotCloseThroughItsNeighbour) {
  const HandModel& hand = sim_test_hand();
  const DigitSurface index(hand, kIndex), middle(hand, kMiddle);
  const PlacedObject rod = rod_under_fingers();
  const JointAngles middle_closed =
      closed_digit(hand, middle, {}, curled(), rod, JointAngles::Zero());
  DigitGoal crossing = curled();
  crossing.preferred[0] = angle_limits().lower[4];  // towards and through the middle finger
  const JointAngles alone = closed_digit(hand, index, {}, crossing, rod, middle_closed);
  const JointAngles beside = closed_digit(hand, index, {&middle}, crossing, rod, middle_closed);
  const auto tips_apart = [&](const JointAngles& angles) {
    const auto keypoints = posed_keypoints(hand.skeleton, HandPose{{}, angles});
    return (keypoints[8] - keypoints[12]).norm();
  };
  EXPECT_GT(tips_apart(beside), tips_apart(alone) + 0.001);
  EXPECT_GT(tips_apart(beside), 0.8 * (index.radius(2) + middle.radius(2)));
}

}  // namespace
}  // namespace tegata
