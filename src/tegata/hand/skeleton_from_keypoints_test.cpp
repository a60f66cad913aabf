// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skeleton_from_keypoints.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/hand/hand_model.h"
#include "tegata/hand/hand_shape.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

const Rigid3d kSomewhere{so3_exp({0.4, -1.1, 2.0}), {0.2, -0.1, 0.7}};

HandPose relaxed() { return {kSomewhere, relaxed_angles()}; }

TEST(SkeletonFromKeypoints, AtItsAnglesEveryKeypointIsWhereItWas) {
  Random random(1);
  for (const Side side : {Side::right, Side::left}) {
    Skeleton skeleton = right_skeleton(HandShape());
    if (side == Side::left) skeleton = mirrored(skeleton);
    for (int repeat = 0; repeat < 20; ++repeat) {
      auto keypoints = posed_keypoints(skeleton, relaxed());
      // Joints that no hinge explains.
      for (Eigen::Vector3d& keypoint : keypoints) {
        keypoint += 0.003 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      }
      const FoundSkeleton found = skeleton_from_keypoints(keypoints, side);
      EXPECT_EQ(found.skeleton.side, side);
      const auto again = posed_keypoints(found.skeleton, {found.source_from_hand, found.angles});
      for (std::size_t k = 0; k < kKeypointCount; ++k) {
        EXPECT_LT((again[k] - keypoints[k]).norm(), 1e-9) << keypoint_names()[k];
      }
    }
  }
}

TEST(SkeletonFromKeypoints, FindsTheAnglesOfTheBuiltInHand) {
  for (const Side side : {Side::right, Side::left}) {
    Skeleton skeleton = right_skeleton(HandShape());
    if (side == Side::left) skeleton = mirrored(skeleton);
    const FoundSkeleton found = skeleton_from_keypoints(posed_keypoints(skeleton, relaxed()), side);
    // The palm's plane goes through the index and little knuckles, of which the latter lies lower:
    // that turns the frame by some degrees.
    EXPECT_LT((found.angles - relaxed_angles()).cwiseAbs().maxCoeff(), 0.12);
    EXPECT_LT(found.source_from_hand.rotation.angularDistance(kSomewhere.rotation), 0.1);
    for (std::size_t k = 0; k < kKeypointCount; ++k) {
      EXPECT_LT((found.skeleton.keypoints[k] - skeleton.keypoints[k]).norm(), 0.013)
          << keypoint_names()[k];
    }
  }
}

TEST(SkeletonFromKeypoints, ZeroIsAStraightHand) {
  const Skeleton skeleton =
      skeleton_from_keypoints(posed_keypoints(right_skeleton(HandShape()), relaxed()), Side::right)
          .skeleton;
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    const Eigen::Vector3d* joints = &skeleton.keypoints[1 + 4 * digit];
    const double path = (joints[1] - joints[0]).norm() + (joints[2] - joints[1]).norm() +
                        (joints[3] - joints[2]).norm();
    EXPECT_NEAR((joints[3] - joints[0]).norm() / path, 1.0, 1e-3);
    EXPECT_NEAR(joints[3].z(), joints[0].z(), 0.003);
  }
}

TEST(SkeletonFromKeypoints, RefusesTheOtherHand) {
  const auto right = posed_keypoints(right_skeleton(HandShape()), relaxed());
  EXPECT_NO_THROW(skeleton_from_keypoints(right, Side::right));
  EXPECT_THROW(skeleton_from_keypoints(right, Side::left), Error);
}

TEST(SkeletonFromKeypoints, RefusesMillimetresAndMissingBones) {
  auto keypoints = posed_keypoints(right_skeleton(HandShape()), relaxed());
  auto in_millimetres = keypoints;
  for (Eigen::Vector3d& keypoint : in_millimetres) keypoint *= 1000.0;
  EXPECT_THROW(skeleton_from_keypoints(in_millimetres, Side::right), Error);
  keypoints[8] = keypoints[7];
  EXPECT_THROW(skeleton_from_keypoints(keypoints, Side::right), Error);
}

TEST(SkeletonFromKeypoints, RefusesAFist) {
  HandPose fist;
  fist.angles = relaxed_angles();
  fist.angles[5] = 1.5;
  EXPECT_THROW(
      skeleton_from_keypoints(posed_keypoints(right_skeleton(HandShape()), fist), Side::right),
      Error);
}

}  // namespace
}  // namespace tegata
