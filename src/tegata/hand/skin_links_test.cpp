// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_links.h"

#include <gtest/gtest.h>

#include <set>

#include "tegata/base/random.h"
#include "tegata/hand/test_hand.h"

namespace tegata {
namespace {

BoneSegments test_segments() {
  return bone_segments(test_skeleton(), JointAngles::Zero(), 0.05, 0.03);
}

TEST(LinkToBones, WeightsSumToOneAndOnlyNeighboursShare) {
  const BoneSegments segments = test_segments();
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d point(random.uniform(-0.1, 0.1), random.uniform(-0.06, 0.2),
                                random.uniform(-0.03, 0.03));
    const SkinLinks links = link_to_bones(segments, point);
    EXPECT_NEAR(links.weights[0] + links.weights[1], 1.0, 1e-12);
    EXPECT_GE(links.weights[0], 0.5);
    const int a = links.bones[0], b = links.bones[1];
    EXPECT_TRUE(parent_bone(a) == b || parent_bone(b) == a) << a << ' ' << b;
  }
}

TEST(LinkToBones, MiddleOfABoneIsRigid) {
  const Skeleton skeleton = test_skeleton();
  for (int bone = 4; bone < kBoneCount; ++bone) {
    const auto near = static_cast<std::size_t>(proximal_keypoint(bone));
    const Eigen::Vector3d middle = 0.5 * (skeleton.keypoints[near] + skeleton.keypoints[near + 1]);
    const SkinLinks links =
        link_to_bones(test_segments(), middle + Eigen::Vector3d(0.0, 0.0, 0.008));
    EXPECT_EQ(main_bone(links), bone);
    EXPECT_EQ(links.weights[0], 1.0);
  }
}

TEST(LinkToBones, BesideAJointBothBonesShareEvenly) {
  const Skeleton skeleton = test_skeleton();
  for (const std::size_t joint : {std::size_t{6}, std::size_t{11}, std::size_t{19}}) {
    const SkinLinks links = link_to_bones(
        test_segments(), skeleton.keypoints[joint] + Eigen::Vector3d(0.0, 0.0, 0.009));
    EXPECT_NEAR(links.weights[0], 0.5, 1e-9);
    EXPECT_NEAR(links.weights[1], 0.5, 1e-9);
  }
}

TEST(LinkToBones, WeightFallsSteadilyAcrossAJoint) {
  const Skeleton skeleton = test_skeleton();
  const Eigen::Vector3d joint = skeleton.keypoints[10];
  const Eigen::Vector3d along = (skeleton.keypoints[11] - skeleton.keypoints[10]).normalized();
  double before = 1.1;
  for (double step = -0.012; step < 0.012; step += 0.0005) {
    const SkinLinks links =
        link_to_bones(test_segments(), joint + step * along + Eigen::Vector3d(0.0, 0.0, 0.008));
    double proximal = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      if (links.bones[i] == 7) proximal += links.weights[i];
    }
    EXPECT_LE(proximal, before + 1e-9);
    EXPECT_GT(proximal, before - 0.12) << "a step in the surface at " << step;
    before = std::min(proximal, 1.0);
  }
  EXPECT_LT(before, 1e-3);
}

TEST(LinkToBones, WebGoesHalfWayWithTheFingers) {
  const Skeleton skeleton = test_skeleton();
  // Between index and middle finger, a third of their first bones out from the knuckles.
  const Eigen::Vector3d web = (skeleton.keypoints[5] + skeleton.keypoints[9]) / 3.0 +
                              (skeleton.keypoints[6] + skeleton.keypoints[10]) / 6.0;
  const SkinLinks links = link_to_bones(test_segments(), web);
  double palm = 0.0;
  for (std::size_t i = 0; i < 2; ++i) palm += links.bones[i] == 0 ? links.weights[i] : 0.0;
  EXPECT_GT(palm, 0.1);
  EXPECT_LT(palm, 0.9);
}

TEST(SmoothPalmLinks, EvensOutTheWebAndLeavesFingersAlone) {
  HandModel model = test_hand();
  // One octahedron's vertices: palm and index finger by halves, but for one that is all finger.
  for (std::size_t i = 0; i < 6; ++i) {
    model.links[i].bones = {0, 4, 0, 0};
    model.links[i].weights = {0.5, 0.5, 0.0, 0.0};
    model.links[6 + i].bones = {5, 6, 0, 0};
    model.links[6 + i].weights = {i == 0 ? 1.0 : 0.5, i == 0 ? 0.0 : 0.5, 0.0, 0.0};
  }
  model.links[0].weights = {0.0, 1.0, 0.0, 0.0};
  std::vector<SkinLinks> links = model.links;
  smooth_palm_links(model.rest_surface, 2, links);
  EXPECT_EQ(links[0].bones[0], 4) << "the heavier bone comes first";
  EXPECT_GT(links[0].weights[1], 0.2);
  EXPECT_LT(links[0].weights[1], 0.5);
  EXPECT_EQ(links[6].weights[0], 1.0);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(std::set(links[i].bones.begin(), links[i].bones.end()),
              std::set(model.links[i].bones.begin(), model.links[i].bones.end()));
    EXPECT_GE(links[i].weights[0], links[i].weights[1]);
    EXPECT_NEAR(links[i].weights[0] + links[i].weights[1], 1.0, 1e-12);
  }
}

TEST(LinkToBones, ForearmStaysWithThePalm) {
  for (double x = -0.03; x <= 0.03; x += 0.005) {
    for (const double z : {-0.02, 0.02}) {
      const SkinLinks links = link_to_bones(test_segments(), {x, -0.03, z});
      EXPECT_EQ(main_bone(links), 0);
      EXPECT_GT(links.weights[0], 0.99) << x;
    }
  }
}

}  // namespace
}  // namespace tegata
