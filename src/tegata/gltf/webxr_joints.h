// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace tegata {

inline constexpr int kWebxrJointCount = 25;

/// A joint of a hand as the WebXR Hand Input module names it. WebXR's joints are where a bone
/// begins: its thumb-metacarpal is the CMC joint, its index-finger-phalanx-proximal the MCP joint.
struct WebxrJoint {
  std::string_view name;
  int parent;    ///< its place in the list; -1 for the wrist
  int bone;      ///< that it moves with
  int keypoint;  ///< that lies at it; -1 for the fingers' metacarpals, which move with the palm
};

/// In the order of the specification: the wrist, then each digit from the thumb outwards.
const std::array<WebxrJoint, kWebxrJointCount>& webxr_joints();

}  // namespace tegata
