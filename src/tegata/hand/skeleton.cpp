// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skeleton.h"

#include <cmath>

#include "tegata/base/angle.h"

namespace tegata {
namespace {

struct Range {
  double lower, upper;  // [deg]
};

// Sources: AAOS: American Academy of Orthopaedic Surgeons, Joint Motion: Method of Measuring and
// Recording, 1965. Hume: Hume, Gellman, McKellop, Brumfield, Functional range of motion of the
// joints of the hand, J Hand Surg 15A, 1990 (active ranges of 35 men). Cooney: Cooney, Lucca, Chao,
// Linscheid, The kinesiology of the thumb trapeziometacarpal joint, J Bone Joint Surg 63A, 1981.
constexpr Range kThumbRanges[4] = {
    {-5.0,
     60.0},  // CMC abduction: AAOS 70 including the skin's share; Cooney 42 of the joint alone
    {-20.0, 45.0},  // CMC flexion: AAOS extension 20; Cooney 53 from end to end; the more flexed
                    // end includes the pronation that the model does not have
    {-10.0, 60.0},  // MCP flexion: AAOS 50, Hume 56, extension up to 10
    {-15.0, 80.0},  // IP flexion: AAOS 80 and extension 20, Hume 73
};
constexpr Range kFingerRanges[4] = {
    {-20.0, 25.0},  // MCP abduction: AAOS records it as a spread in length, not in degrees; the
                    // range is that of a finger crossing its neighbour to a full spread
    {-25.0, 95.0},  // MCP flexion: AAOS 90 and passive extension 45, Hume 100
    {-3.0, 105.0},  // PIP flexion: AAOS 100, Hume 105
    {-5.0, 85.0},   // DIP flexion: AAOS 90 and extension 10, Hume 85
};

Eigen::Quaterniond turn_by(const Skeleton& skeleton, const JointAngles& angles, int angle) {
  const double half = 0.5 * angles[angle];
  const Eigen::Vector3d imaginary = std::sin(half) * skeleton.axes[static_cast<std::size_t>(angle)];
  return {std::cos(half), imaginary.x(), imaginary.y(), imaginary.z()};
}

// A hand at rest, in degrees: the fingers curl more from the index to the little finger, as the
// flexors' resting tension makes them do.
constexpr double kRelaxed[kAngleCount] = {
    25.0, 5.0,  15.0, 15.0,  // thumb
    2.0,  22.0, 30.0, 12.0,  // index
    0.0,  28.0, 34.0, 14.0,  // middle
    2.0,  32.0, 36.0, 16.0,  // ring
    6.0,  35.0, 36.0, 16.0,  // little
};

}  // namespace

std::string_view side_name(Side side) { return side == Side::right ? "right" : "left"; }

const std::array<std::string_view, kAngleCount>& angle_names() {
  static constexpr std::array<std::string_view, kAngleCount> names = {
      "thumb_cmc_abduction",  "thumb_cmc_flexion",  "thumb_mcp_flexion",  "thumb_ip_flexion",
      "index_mcp_abduction",  "index_mcp_flexion",  "index_pip_flexion",  "index_dip_flexion",
      "middle_mcp_abduction", "middle_mcp_flexion", "middle_pip_flexion", "middle_dip_flexion",
      "ring_mcp_abduction",   "ring_mcp_flexion",   "ring_pip_flexion",   "ring_dip_flexion",
      "little_mcp_abduction", "little_mcp_flexion", "little_pip_flexion", "little_dip_flexion"};
  return names;
}

const std::array<std::string_view, kKeypointCount>& keypoint_names() {
  static constexpr std::array<std::string_view, kKeypointCount> names = {
      "wrist",                                                 //
      "thumb_cmc",  "thumb_mcp",  "thumb_ip",   "thumb_tip",   //
      "index_mcp",  "index_pip",  "index_dip",  "index_tip",   //
      "middle_mcp", "middle_pip", "middle_dip", "middle_tip",  //
      "ring_mcp",   "ring_pip",   "ring_dip",   "ring_tip",    //
      "little_mcp", "little_pip", "little_dip", "little_tip"};
  return names;
}

const std::array<std::string_view, kBoneCount>& bone_names() {
  static constexpr std::array<std::string_view, kBoneCount> names = {
      "palm",          "thumb_metacarpal", "thumb_proximal",  //
      "thumb_distal",  "index_proximal",   "index_middle",    //
      "index_distal",  "middle_proximal",  "middle_middle",   //
      "middle_distal", "ring_proximal",    "ring_middle",     //
      "ring_distal",   "little_proximal",  "little_middle",   //
      "little_distal"};
  return names;
}

const AngleLimits& angle_limits() {
  static const AngleLimits limits = [] {
    AngleLimits made;
    for (int angle = 0; angle < kAngleCount; ++angle) {
      const Range& range = angle < 4 ? kThumbRanges[angle] : kFingerRanges[angle % 4];
      made.lower[angle] = range.lower * kDegree;
      made.upper[angle] = range.upper * kDegree;
    }
    return made;
  }();
  return limits;
}

const JointAngles& relaxed_angles() {
  static const JointAngles angles = Eigen::Map<const JointAngles>(kRelaxed) * kDegree;
  return angles;
}

Skeleton mirrored(const Skeleton& skeleton) {
  Skeleton other = skeleton;
  other.side = skeleton.side == Side::right ? Side::left : Side::right;
  for (Eigen::Vector3d& keypoint : other.keypoints) keypoint.x() = -keypoint.x();
  // The mirror image of a turn about an axis is the same turn about the negated mirrored axis.
  for (Eigen::Vector3d& axis : other.axes) axis = Eigen::Vector3d(axis.x(), -axis.y(), -axis.z());
  return other;
}

std::array<Rigid3d, kBoneCount> bone_transforms(const Skeleton& skeleton, const JointAngles& angles,
                                                const Rigid3d& palm) {
  std::array<Rigid3d, kBoneCount> transforms;
  transforms[0] = palm;
  for (int bone = 1; bone < kBoneCount; ++bone) {
    const Rigid3d& parent = transforms[static_cast<std::size_t>(parent_bone(bone))];
    const Eigen::Vector3d& center =
        skeleton.keypoints[static_cast<std::size_t>(proximal_keypoint(bone))];
    const int digit = (bone - 1) / 3, joint = (bone - 1) % 3;
    Rigid3d& moved = transforms[static_cast<std::size_t>(bone)];
    moved.rotation = parent.rotation;
    if (joint == 0) moved.rotation *= turn_by(skeleton, angles, 4 * digit);
    moved.rotation *= turn_by(skeleton, angles, 4 * digit + 1 + joint);
    moved.rotation.normalize();
    moved.translation = parent * center - moved.rotation * center;
  }
  return transforms;
}

std::array<JointAxis, kAngleCount> joint_axes(const Skeleton& skeleton, const JointAngles& angles) {
  return joint_axes(skeleton, bone_transforms(skeleton, angles));
}

std::array<JointAxis, kAngleCount> joint_axes(const Skeleton& skeleton,
                                              const std::array<Rigid3d, kBoneCount>& transforms) {
  std::array<JointAxis, kAngleCount> axes;
  for (int angle = 0; angle < kAngleCount; ++angle) {
    const int bone = bone_of_angle(angle);
    const Rigid3d& parent = transforms[static_cast<std::size_t>(parent_bone(bone))];
    JointAxis& axis = axes[static_cast<std::size_t>(angle)];
    axis.center = parent * skeleton.keypoints[static_cast<std::size_t>(proximal_keypoint(bone))];
    // A flexion's axis lies still under its own turn, so the bone's whole transform carries it as
    // the abduction alone does; the abduction's is carried by the bone above only.
    const Rigid3d& carrier = angle % 4 == 0 ? parent : transforms[static_cast<std::size_t>(bone)];
    axis.direction = carrier.rotation * skeleton.axes[static_cast<std::size_t>(angle)];
  }
  return axes;
}

}  // namespace tegata
