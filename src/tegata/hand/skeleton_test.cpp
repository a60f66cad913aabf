// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skeleton.h"

#include <gtest/gtest.h>

#include <string>

#include "tegata/base/angle.h"
#include "tegata/hand/test_hand.h"

namespace tegata {
namespace {

std::array<Eigen::Vector3d, kKeypointCount> keypoints_at(const Skeleton& skeleton,
                                                         const JointAngles& angles) {
  const auto transforms = bone_transforms(skeleton, angles);
  std::array<Eigen::Vector3d, kKeypointCount> points;
  for (int k = 0; k < kKeypointCount; ++k) {
    const auto i = static_cast<std::size_t>(k);
    points[i] = transforms[static_cast<std::size_t>(bone_of_keypoint(k))] * skeleton.keypoints[i];
  }
  return points;
}

TEST(Skeleton, TreeIsThatOfAHand) {
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const int first = 1 + 3 * digit;
    EXPECT_EQ(parent_bone(first), 0);
    EXPECT_EQ(parent_bone(first + 1), first);
    EXPECT_EQ(parent_bone(first + 2), first + 1);
    EXPECT_EQ(bone_of_keypoint(distal_keypoint(first + 2)), first + 2);
  }
  for (int bone = 1; bone < kBoneCount; ++bone) {
    EXPECT_EQ(bone_of_keypoint(proximal_keypoint(bone)), parent_bone(bone)) << bone;
  }
}

TEST(Skeleton, NamesAgreeWithTheTree) {
  for (int angle = 0; angle < kAngleCount; ++angle) {
    const std::string name(angle_names()[static_cast<std::size_t>(angle)]);
    const std::string joint(
        keypoint_names()[static_cast<std::size_t>(proximal_keypoint(bone_of_angle(angle)))]);
    EXPECT_EQ(name.substr(0, joint.size()), joint);
  }
  for (int bone = 1; bone < kBoneCount; ++bone) {
    const std::string name(bone_names()[static_cast<std::size_t>(bone)]);
    const std::string joint(keypoint_names()[static_cast<std::size_t>(proximal_keypoint(bone))]);
    EXPECT_EQ(name.substr(0, name.find('_')), joint.substr(0, joint.find('_')));
  }
}

TEST(Skeleton, ZeroAnglesMoveNothing) {
  for (const Rigid3d& transform : bone_transforms(test_skeleton(), JointAngles::Zero())) {
    EXPECT_LT(transform.translation.norm(), 1e-12);
    EXPECT_LT(transform.rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-12);
  }
}

TEST(Skeleton, BonesKeepTheirLengths) {
  const Skeleton skeleton = test_skeleton();
  const auto points = keypoints_at(skeleton, random_angles(1));
  for (int bone = 1; bone < kBoneCount; ++bone) {
    const auto near = static_cast<std::size_t>(proximal_keypoint(bone)), far = near + 1;
    EXPECT_NEAR((points[far] - points[near]).norm(),
                (skeleton.keypoints[far] - skeleton.keypoints[near]).norm(), 1e-12);
  }
}

TEST(Skeleton, FlexionGoesToThePalmAndAbductionFromTheMiddleFinger) {
  for (const Skeleton& skeleton : {test_skeleton(), mirrored(test_skeleton())}) {
    const double ulnar = skeleton.side == Side::right ? 1.0 : -1.0;
    for (int digit = 1; digit < kDigitCount; ++digit) {
      const auto tip = static_cast<std::size_t>(4 * digit + 4);
      JointAngles angles = JointAngles::Zero();
      angles[4 * digit + 1] = 0.3;
      EXPECT_LT(keypoints_at(skeleton, angles)[tip].z(), skeleton.keypoints[tip].z() - 0.01);
      angles[4 * digit + 1] = 0.0;
      angles[4 * digit] = 0.2;
      const double moved = keypoints_at(skeleton, angles)[tip].x() - skeleton.keypoints[tip].x();
      EXPECT_GT(moved * ulnar * (digit <= 2 ? -1.0 : 1.0), 0.005) << digit;
    }
  }
}

TEST(Skeleton, AbductionCarriesTheFlexionAxisOfItsJoint) {
  const Skeleton skeleton = test_skeleton();
  JointAngles angles = JointAngles::Zero();
  angles[4] = 0.4;
  const auto axes = joint_axes(skeleton, angles);
  EXPECT_LT((axes[4].direction - skeleton.axes[4]).norm(), 1e-12);
  const Eigen::Vector3d turned =
      rotation_about(Eigen::Vector3d::Zero(), skeleton.axes[4] * 0.4).rotation * skeleton.axes[5];
  EXPECT_LT((axes[5].direction - turned).norm(), 1e-12);
}

// An axis is right if a small turn about it is what a small change of its angle does to the bones.
TEST(Skeleton, JointAxesAreWhereTheAnglesTurnTheBones) {
  const Skeleton skeleton = test_skeleton();
  const double step = 1e-6;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const JointAngles angles = random_angles(seed);
    const auto axes = joint_axes(skeleton, angles);
    const auto before = bone_transforms(skeleton, angles);
    for (int angle = 0; angle < kAngleCount; ++angle) {
      JointAngles more = angles;
      more[angle] += step;
      const auto after = bone_transforms(skeleton, more);
      const JointAxis& axis = axes[static_cast<std::size_t>(angle)];
      for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
        const Eigen::Vector3d point = before[bone] * Eigen::Vector3d(0.02, 0.1, -0.03);
        const Eigen::Vector3d expected =
            angle_moves_bone(angle, static_cast<int>(bone))
                ? Eigen::Vector3d(rotation_about(axis.center, step * axis.direction) * point)
                : point;
        EXPECT_LT((after[bone] * Eigen::Vector3d(0.02, 0.1, -0.03) - expected).norm(), 1e-12)
            << angle << ' ' << bone;
      }
    }
  }
}

TEST(Skeleton, MirroredTwiceIsTheSame) {
  const Skeleton skeleton = test_skeleton(), twice = mirrored(mirrored(skeleton));
  EXPECT_EQ(twice.side, skeleton.side);
  EXPECT_EQ(twice.keypoints, skeleton.keypoints);
  EXPECT_EQ(twice.axes, skeleton.axes);
}

TEST(Skeleton, MirroredHandKeepsTheSignsOfTheAngles) {
  const Skeleton skeleton = test_skeleton(), other = mirrored(skeleton);
  EXPECT_NE(other.side, skeleton.side);
  const JointAngles angles = random_angles(2);
  const auto points = keypoints_at(skeleton, angles), mirror = keypoints_at(other, angles);
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    const Eigen::Vector3d expected(-points[k].x(), points[k].y(), points[k].z());
    EXPECT_LT((mirror[k] - expected).norm(), 1e-12) << k;
  }
}

TEST(AngleLimits, HoldTheFlatAndTheRelaxedHand) {
  const AngleLimits& limits = angle_limits();
  EXPECT_TRUE((limits.lower.array() <= 0.0).all() && (limits.upper.array() >= 0.0).all());
  EXPECT_TRUE((limits.lower.array() < relaxed_angles().array()).all());
  EXPECT_TRUE((limits.upper.array() > relaxed_angles().array()).all());
  EXPECT_LT(limits.upper.maxCoeff(), 110.0 * kDegree) << "degrees for radians";
}

}  // namespace
}  // namespace tegata
