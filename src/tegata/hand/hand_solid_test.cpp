// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/hand_solid.h"

#include <gtest/gtest.h>

#include "tegata/base/random.h"
#include "tegata/hand/hand_model.h"

namespace tegata {
namespace {

Eigen::Vector3d random_point(Random& random, const Eigen::AlignedBox3d& box) {
  Eigen::Vector3d point;
  for (int i = 0; i < 3; ++i) point[i] = random.uniform(box.min()[i], box.max()[i]);
  return point;
}

HandSolid mean_solid() { return {right_skeleton(HandShape()), meshing_angles()}; }

TEST(RoundedCone, OfEqualEndsIsTheDistanceToACapsule) {
  const RoundedCone cone({{0.0, 0.0, 0.0}, {0.0, 0.1, 0.0}, 0.01, 0.01}, Eigen::Vector3d::UnitZ(),
                         1.0);
  EXPECT_NEAR(cone.field({0.0, 0.05, 0.0}), 0.01, 1e-12);
  EXPECT_NEAR(cone.field({0.03, 0.05, 0.04}), -0.04, 1e-12);
  EXPECT_NEAR(cone.field({0.0, 0.13, 0.04}), -0.04, 1e-12);
}

TEST(RoundedCone, HoldsEveryBallBetweenItsEnds) {
  const Eigen::Vector3d a(0.01, 0.0, 0.02), b(0.03, 0.08, 0.0);
  const RoundedCone cone({a, b, 0.02, 0.008}, Eigen::Vector3d::UnitZ(), 1.0);
  Random random(1);
  double nearest = -1.0;
  for (int i = 0; i < 2000; ++i) {
    const double part = random.uniform();
    const Eigen::Vector3d center = a + part * (b - a);
    const Eigen::Vector3d way(random.normal(), random.normal(), random.normal());
    const double field = cone.field(center + (0.02 - 0.012 * part) * way.normalized());
    EXPECT_GT(field, -1e-9);
    nearest = nearest < 0.0 ? field : std::min(nearest, field);
  }
  EXPECT_LT(nearest, 2e-4) << "the surface is where the balls are";
}

TEST(RoundedCone, IsFlattenedAlongTheGivenDirection) {
  const RoundedCone cone({{0.0, 0.0, 0.0}, {0.0, 0.1, 0.0}, 0.03, 0.03}, Eigen::Vector3d::UnitZ(),
                         0.7);
  EXPECT_NEAR(cone.field({0.03, 0.05, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(cone.field({0.0, 0.05, 0.021}), 0.0, 1e-12);
}

// The octree leaves out what a field no steeper than 1 says is far from the surface.
TEST(HandSolid, FieldIsNowhereSteeperThanOne) {
  const HandSolid solid = mean_solid();
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d a = random_point(random, solid.box());
    const Eigen::Vector3d b =
        a + 0.01 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    EXPECT_LE(std::abs(solid.field(a) - solid.field(b)), (a - b).norm() * (1.0 + 1e-9));
  }
}

TEST(HandSolid, NothingLiesOutsideItsBox) {
  const HandSolid solid = mean_solid();
  const Eigen::AlignedBox3d box = solid.box();
  const Eigen::AlignedBox3d wide(box.min() - 0.5 * box.sizes(), box.max() + 0.5 * box.sizes());
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d point = random_point(random, wide);
    if (!box.contains(point)) {
      EXPECT_LT(solid.field(point), 0.0);
    }
  }
}

TEST(HandSolid, HoldsEveryJoint) {
  const Skeleton skeleton = right_skeleton(HandShape());
  const HandSolid solid = mean_solid();
  HandPose pose;
  pose.angles = meshing_angles();
  const auto points = posed_keypoints(skeleton, pose);
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    if (k % 4 == 0 && k > 0) {
      EXPECT_NEAR(solid.field(points[k]), 0.0, 0.001) << keypoint_names()[k];
    } else {
      EXPECT_GT(solid.field(points[k]), 0.005) << keypoint_names()[k];
    }
  }
}

// Half the thickness of the last bone and its nail bed: where the surface sinks below, straight
// fingers look bent at their last joint.
TEST(HandSolid, NailLiesOnTheEndOfTheLastBone) {
  constexpr double kBoneEnd = 0.82;  // of the way to the tip
  constexpr double kBoneAndBed = 0.0044;
  const Skeleton skeleton = right_skeleton(HandShape());
  const HandSolid solid(skeleton, JointAngles::Zero());
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    const Eigen::Vector3d& joint = skeleton.keypoints[3 + 4 * digit];
    const Eigen::Vector3d& tip = skeleton.keypoints[4 + 4 * digit];
    const Eigen::Vector3d end = joint + kBoneEnd * (tip - joint);
    EXPECT_GT(solid.field(end + kBoneAndBed * neutral_digit(digit).back), 0.0) << digit;
  }
}

TEST(HandSolid, FingersDoNotTouchWhereTheyAreMeshed) {
  const Skeleton skeleton = right_skeleton(HandShape());
  const HandSolid solid = mean_solid();
  HandPose pose;
  pose.angles = meshing_angles();
  const auto points = posed_keypoints(skeleton, pose);
  for (std::size_t digit = 0; digit + 1 < kDigitCount; ++digit) {
    for (std::size_t i = 2; i < 5; ++i) {
      const Eigen::Vector3d between = 0.5 * (points[i + 4 * digit] + points[i + 4 * digit + 4]);
      EXPECT_LT(solid.field(between), 0.0) << digit << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace tegata
