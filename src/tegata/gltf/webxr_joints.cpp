// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/webxr_joints.h"

namespace tegata {

const std::array<WebxrJoint, kWebxrJointCount>& webxr_joints() {
  static constexpr std::array<WebxrJoint, kWebxrJointCount> joints = {{
      {"wrist", -1, 0, 0},
      {"thumb-metacarpal", 0, 1, 1},
      {"thumb-phalanx-proximal", 1, 2, 2},
      {"thumb-phalanx-distal", 2, 3, 3},
      {"thumb-tip", 3, 3, 4},
      {"index-finger-metacarpal", 0, 0, -1},
      {"index-finger-phalanx-proximal", 5, 4, 5},
      {"index-finger-phalanx-intermediate", 6, 5, 6},
      {"index-finger-phalanx-distal", 7, 6, 7},
      {"index-finger-tip", 8, 6, 8},
      {"middle-finger-metacarpal", 0, 0, -1},
      {"middle-finger-phalanx-proximal", 10, 7, 9},
      {"middle-finger-phalanx-intermediate", 11, 8, 10},
      {"middle-finger-phalanx-distal", 12, 9, 11},
      {"middle-finger-tip", 13, 9, 12},
      {"ring-finger-metacarpal", 0, 0, -1},
      {"ring-finger-phalanx-proximal", 15, 10, 13},
      {"ring-finger-phalanx-intermediate", 16, 11, 14},
      {"ring-finger-phalanx-distal", 17, 12, 15},
      {"ring-finger-tip", 18, 12, 16},
      {"pinky-finger-metacarpal", 0, 0, -1},
      {"pinky-finger-phalanx-proximal", 20, 13, 17},
      {"pinky-finger-phalanx-intermediate", 21, 14, 18},
      {"pinky-finger-phalanx-distal", 22, 15, 19},
      {"pinky-finger-tip", 23, 15, 20},
  }};
  return joints;
}

}  // namespace tegata
