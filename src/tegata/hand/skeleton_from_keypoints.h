// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "tegata/hand/skeleton.h"

namespace tegata {

/// A skeleton and the pose in which its joints were found.
struct FoundSkeleton {
  Skeleton skeleton;
  JointAngles angles;
  Rigid3d source_from_hand;  ///< from the hand's frame to that of the keypoints
};

/// The skeleton of a hand of which nothing is known but where its 21 keypoints are, in any frame
/// [m], the hand in any pose that is not far from flat (no finger bent by 75 degrees or more at its
/// MCP joint). Bone lengths are kept, so that the skeleton at `angles` has every keypoint where it
/// was. Zero angles and axes are those of the built-in hand; where a digit's two outer joints are
/// bent, their axes are turned towards the plane it is bent in, and what lies across that plane
/// stays in the skeleton. The palm's plane is that of the wrist and the index and little MCP
/// joints as seen along the middle one. Throws Error where a bone has no length, the thumb is on
/// the little finger's side or the digits bend to the back of the hand, which is what the other
/// hand's joints look like.
FoundSkeleton skeleton_from_keypoints(const std::array<Eigen::Vector3d, kKeypointCount>& keypoints,
                                      Side side);

}  // namespace tegata
