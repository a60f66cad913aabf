// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "tegata/math/rigid3d.h"

namespace tegata {

inline constexpr int kAngleCount = 20;         ///< joint angles
inline constexpr int kPoseParameterCount = 6;  ///< rotation 3, translation 3
inline constexpr int kHandParameterCount = kPoseParameterCount + kAngleCount;
inline constexpr int kBoneCount = 16;      ///< the palm and three a digit
inline constexpr int kKeypointCount = 21;  ///< wrist and four a digit
inline constexpr int kDigitCount = 5;
/// Keypoints that are asked for by name.
inline constexpr int kWrist = 0, kIndexMcp = 5, kMiddleMcp = 9, kMiddleTip = 12, kLittleMcp = 17;

/// The joint angles [rad] in the order of angle_names(): thumb CMC abduction, CMC flexion, MCP
/// flexion, IP flexion; then for index, middle, ring and little finger MCP abduction, MCP flexion,
/// PIP flexion, DIP flexion. Flexion is positive towards the palm, abduction away from the middle
/// finger (the thumb's away from the palm); zero is the flat hand with straight fingers and the
/// thumb in the plane of the palm. Both hands have the same signs.
using JointAngles = Eigen::Matrix<double, kAngleCount, 1>;

enum class Side { right, left };
std::string_view side_name(Side side);

/// "thumb_cmc_abduction" ... "little_dip_flexion".
const std::array<std::string_view, kAngleCount>& angle_names();
/// "wrist", "thumb_cmc", "thumb_mcp", "thumb_ip", "thumb_tip", "index_mcp" ... "little_tip".
const std::array<std::string_view, kKeypointCount>& keypoint_names();
/// "palm", "thumb_metacarpal", "thumb_proximal", "thumb_distal", "index_proximal", "index_middle",
/// "index_distal" ... "little_distal".
const std::array<std::string_view, kBoneCount>& bone_names();

/// The bone that a bone hangs from; -1 for the palm, bone 0.
constexpr int parent_bone(int bone) { return bone == 0 ? -1 : (bone % 3 == 1 ? 0 : bone - 1); }
/// The keypoint at a bone's near end: the wrist for the palm, the joint that moves it for others.
constexpr int proximal_keypoint(int bone) {
  return bone == 0 ? 0 : 1 + 4 * ((bone - 1) / 3) + (bone - 1) % 3;
}
/// The keypoint at the far end of a finger's or the thumb's bone (not for the palm).
constexpr int distal_keypoint(int bone) { return proximal_keypoint(bone) + 1; }
/// The bone that an angle turns about the bone's proximal keypoint. Where a joint has two angles
/// the abduction comes first and carries the flexion's axis with it.
constexpr int bone_of_angle(int angle) {
  const int digit = angle / 4, within = angle % 4;
  return 1 + 3 * digit + (within < 2 ? 0 : within - 1);
}
/// The bone that a keypoint is fixed to: for joints the bone above, so that it moves with its
/// parent.
constexpr int bone_of_keypoint(int keypoint) {
  if (keypoint == 0) return 0;
  const int digit = (keypoint - 1) / 4, within = (keypoint - 1) % 4;
  return within == 0 ? 0 : 3 * digit + within;
}
/// Whether turning an angle moves a bone.
constexpr bool angle_moves_bone(int angle, int bone) {
  const int moved = bone_of_angle(angle);
  return bone >= moved && bone > 0 && (bone - 1) / 3 == (moved - 1) / 3;
}

struct AngleLimits {
  JointAngles lower, upper;  ///< [rad]
};
/// Active ranges of motion of healthy adults, with the source beside each number in the table.
const AngleLimits& angle_limits();
/// A relaxed, slightly bent hand: where an angle goes that nothing is known of.
const JointAngles& relaxed_angles();

/// Where the joints are and which way they turn, in the hand's frame at zero angles. The hand's
/// frame: origin at the wrist's centre, y towards the middle finger's MCP joint, z out of the back
/// of the hand, x = y x z, which for a right hand is towards the little finger. A left hand is the
/// mirror image in x.
struct Skeleton {
  Side side = Side::right;
  std::array<Eigen::Vector3d, kKeypointCount> keypoints;  ///< [m]
  std::array<Eigen::Vector3d, kAngleCount> axes;          ///< unit, right-handed turn is positive
};

/// The other hand: keypoints mirrored in x, axes so that the signs of the angles stay.
Skeleton mirrored(const Skeleton& skeleton);

/// For each bone the transform, in the hand's frame, from where it lies at zero angles to where the
/// angles take it. The palm's is the identity, or wherever it is taken with all of them.
std::array<Rigid3d, kBoneCount> bone_transforms(const Skeleton& skeleton, const JointAngles& angles,
                                                const Rigid3d& palm = {});

/// A turn that one angle makes, in the hand's frame at given angles.
struct JointAxis {
  Eigen::Vector3d center, direction;
};
/// The axes of all angles where the angles take them.
std::array<JointAxis, kAngleCount> joint_axes(const Skeleton& skeleton, const JointAngles& angles);
/// The same, where bone_transforms() of the angles are there already; taken where the palm is.
std::array<JointAxis, kAngleCount> joint_axes(const Skeleton& skeleton,
                                              const std::array<Rigid3d, kBoneCount>& transforms);

}  // namespace tegata
