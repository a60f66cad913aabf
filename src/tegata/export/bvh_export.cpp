// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/bvh_export.h"

#include <fmt/format.h>

#include <array>

#include "tegata/base/angle.h"
#include "tegata/export/exported_frames.h"

namespace tegata {
namespace {

constexpr double kCentimetres = 100.0;
constexpr int kDecimals = 6;

// The middle one of the three is about the y of the hand, along the fingers, which hardly twist: so
// no finger comes near a quarter turn of it, where the other two could not be told apart.
constexpr std::string_view kRotations = "Zrotation Yrotation Xrotation";

std::size_t joint_index(int i) { return static_cast<std::size_t>(i); }

std::string indented(int depth, const std::string& line) {
  return std::string(2 * joint_index(depth), ' ') + line + "\n";
}

std::string offset(const Eigen::Vector3d& way) {
  return fmt::format("OFFSET {} {} {}", decimal(kCentimetres * way.x(), kDecimals),
                     decimal(kCentimetres * way.y(), kDecimals),
                     decimal(kCentimetres * way.z(), kDecimals));
}

/// A digit's joints, each within the one before, and its tip.
std::string digit_joints(const Skeleton& skeleton, int digit) {
  const int first = 1 + 4 * digit;
  std::string block;
  for (int i = 0; i < 3; ++i) {
    const int above = i == 0 ? 0 : first + i - 1;
    const Eigen::Vector3d way =
        skeleton.keypoints[joint_index(first + i)] - skeleton.keypoints[joint_index(above)];
    block += indented(i + 1, fmt::format("JOINT {}", keypoint_names()[joint_index(first + i)]));
    block += indented(i + 1, "{");
    block += indented(i + 2, offset(way));
    block += indented(i + 2, fmt::format("CHANNELS 3 {}", kRotations));
  }
  const Eigen::Vector3d way =
      skeleton.keypoints[joint_index(first + 3)] - skeleton.keypoints[joint_index(first + 2)];
  block += indented(4, "End Site") + indented(4, "{") + indented(5, offset(way));
  for (int depth = 4; depth > 0; --depth) block += indented(depth, "}");
  return block;
}

std::string hierarchy(const Skeleton& skeleton) {
  std::string block = fmt::format("HIERARCHY\nROOT {}\n{{\n", keypoint_names()[0]);
  block += indented(1, "OFFSET 0.000000 0.000000 0.000000");
  block += indented(1, fmt::format("CHANNELS 6 Xposition Yposition Zposition {}", kRotations));
  for (int digit = 0; digit < kDigitCount; ++digit) block += digit_joints(skeleton, digit);
  return block + "}\n";
}

}  // namespace

std::string bvh_text(const Result& result, const HandModel& hand) {
  const std::vector<const HandPose*> poses = held_poses(result);
  std::string file = hierarchy(hand.skeleton);
  file += fmt::format("MOTION\nFrames: {}\nFrame Time: {}\n", poses.size(),
                      decimal(frame_interval(result), 9));
  std::array<Eigen::Vector3d, kBoneCount> angles;
  angles.fill(Eigen::Vector3d::Zero());
  for (const HandPose* pose : poses) {
    const Rigid3d y_up_from_hand = y_up_from_world() * pose->world_from_hand;
    const auto bones = bone_transforms(hand.skeleton, pose->angles);
    std::string line;
    for (int i = 0; i < 3; ++i) {
      line += decimal(kCentimetres * y_up_from_hand.translation[i], kDecimals) + " ";
    }
    // Keypoints and bones are in the same order, from the wrist and the palm outwards.
    for (int bone = 0; bone < kBoneCount; ++bone) {
      const Eigen::Quaterniond turn =
          bone == 0 ? y_up_from_hand.rotation
                    : bones[joint_index(parent_bone(bone))].rotation.conjugate() *
                          bones[joint_index(bone)].rotation;
      angles[joint_index(bone)] = zyx_angles(turn, angles[joint_index(bone)]);
      for (int i = 0; i < 3; ++i) {
        line += decimal(kDegreesPerRadian * angles[joint_index(bone)][i], kDecimals) + " ";
      }
    }
    line.back() = '\n';
    file += line;
  }
  return file;
}

}  // namespace tegata
