// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_motion.h"

#include <gtest/gtest.h>

#include "tegata/hand/test_hand.h"

namespace tegata {
namespace {

Eigen::Vector3d vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

TEST(SkinMotion, MovesBonesAndAxesAsTheSkeletonDoes) {
  for (const HandModel& hand : hands_to_check()) {
    SkinMotion motion(hand);
    for (const HandPose& pose : poses_to_check(hand)) {
      motion.move_to(pose);
      const Rigid3d palm{pose.world_from_hand.rotation, Eigen::Vector3d::Zero()};
      const auto from_zero = bone_transforms(hand.skeleton, pose.angles, palm);
      const auto rest_from_zero = bone_transforms(hand.skeleton, hand.rest_angles);
      const auto axes = joint_axes(hand.skeleton, from_zero);
      EXPECT_EQ(motion.origin(), pose.world_from_hand.translation);
      for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
        for (std::size_t i = 0; i < 4; ++i) {
          const std::size_t bone = i == 0 ? 0 : 3 * digit + i;
          const Rigid3d expected = from_zero[bone] * rest_from_zero[bone].inverse();
          const SkinMotion::Bone& found = motion.digit(digit).bones[i];
          EXPECT_LT((vector_of(found.shift) - expected.translation).norm(), 1e-14);
          for (std::size_t row = 0; row < 3; ++row) {
            const Eigen::Vector3d turn =
                expected.rotation.toRotationMatrix().row(static_cast<int>(row));
            EXPECT_LT((vector_of(found.turn[row]) - turn).norm(), 1e-14) << bone;
          }
          const SkinMotion::Axis& axis = motion.digit(digit).axes[i];
          const JointAxis& plain = axes[4 * digit + i];
          EXPECT_LT((vector_of(axis.center) - plain.center).norm(), 1e-14);
          EXPECT_LT((vector_of(axis.direction) - plain.direction).norm(), 1e-14);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tegata
