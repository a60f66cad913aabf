// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/webxr_joints.h"

#include <gtest/gtest.h>

#include <set>

#include "tegata/hand/skeleton.h"

namespace tegata {
namespace {

TEST(WebxrJoints, EveryKeypointAndBoneHasItsJoint) {
  std::set<int> keypoints, bones;
  for (const WebxrJoint& joint : webxr_joints()) {
    if (joint.keypoint >= 0) {
      EXPECT_TRUE(keypoints.insert(joint.keypoint).second) << joint.name;
    }
    bones.insert(joint.bone);
  }
  EXPECT_EQ(keypoints.size(), static_cast<std::size_t>(kKeypointCount));
  EXPECT_EQ(bones.size(), static_cast<std::size_t>(kBoneCount));
}

TEST(WebxrJoints, JointsTurnTheBoneThatBeginsAtThem) {
  for (const WebxrJoint& joint : webxr_joints()) {
    if (joint.keypoint < 0) {
      EXPECT_EQ(joint.bone, 0) << joint.name;
    } else if (joint.name.ends_with("tip")) {
      EXPECT_EQ(joint.bone, bone_of_keypoint(joint.keypoint)) << joint.name;
    } else {
      EXPECT_EQ(joint.keypoint, proximal_keypoint(joint.bone)) << joint.name;
    }
  }
}

TEST(WebxrJoints, ParentsComeFirstAndMoveTheSameBoneOrTheOneAbove) {
  const auto& joints = webxr_joints();
  for (std::size_t i = 1; i < joints.size(); ++i) {
    ASSERT_LT(joints[i].parent, static_cast<int>(i));
    const int above = joints[static_cast<std::size_t>(joints[i].parent)].bone;
    EXPECT_TRUE(joints[i].bone == above || parent_bone(joints[i].bone) == above) << joints[i].name;
  }
}

}  // namespace
}  // namespace tegata
