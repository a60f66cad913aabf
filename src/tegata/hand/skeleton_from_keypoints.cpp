// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skeleton_from_keypoints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"
#include "tegata/hand/hand_shape.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

using Keypoints = std::array<Eigen::Vector3d, kKeypointCount>;

constexpr double kShortestBone = 0.002;   // [m]
constexpr double kLongestBone = 0.2;      // [m]
constexpr double kSteepestFlexion = 1.3;  // [rad], of an MCP joint
constexpr double kSureOfMirror = 0.1;     // sine of the mean bend to the back

void check_bones(const Keypoints& keypoints) {
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const int near = proximal_keypoint(bone), far = bone == 0 ? 9 : distal_keypoint(bone);
    const double length =
        (keypoints[static_cast<std::size_t>(far)] - keypoints[static_cast<std::size_t>(near)])
            .norm();
    if (!(length >= kShortestBone && length <= kLongestBone)) {
      throw Error("hand joints: ", keypoint_names()[static_cast<std::size_t>(near)], " and ",
                  keypoint_names()[static_cast<std::size_t>(far)], " are ", length,
                  " m apart, expected ", kShortestBone, " to ", kLongestBone);
    }
  }
}

/// The hand's frame (skeleton.h) from the joints of the palm.
Rigid3d frame_of_palm(const Keypoints& keypoints, Side side) {
  const Eigen::Vector3d y = (keypoints[9] - keypoints[0]).normalized();
  const Eigen::Vector3d across =
      (side == Side::right ? 1.0 : -1.0) * (keypoints[17] - keypoints[5]);
  const Eigen::Vector3d z = across.cross(y);
  if (z.norm() < kShortestBone) {
    throw Error("hand joints: wrist, index_mcp and little_mcp lie on one line with middle_mcp");
  }
  Eigen::Matrix3d axes;
  axes << y.cross(z.normalized()), y, z.normalized();
  return {Eigen::Quaterniond(axes), keypoints[0]};
}

/// Both hands' joints look alike but for what is palm and what is back.
void check_side(const Keypoints& right, Side side) {
  double rise = 0.0;
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    const Eigen::Vector3d reach = right[4 + 4 * digit] - right[1 + 4 * digit];
    rise += reach.z() / reach.norm() / kDigitCount;
  }
  if (rise > kSureOfMirror) {
    throw Error("hand joints: the digits of the ", side_name(side),
                " hand bend to its back; they are those of the other hand, or mirrored");
  }
  if (right[2].x() > 0.0) {
    throw Error("hand joints: thumb_mcp is on the little finger's side of the ", side_name(side),
                " hand");
  }
}

/// The two angles of a finger's first joint that point it along `direction`.
Eigen::Vector2d finger_root_angles(const NeutralDigit& neutral, const Eigen::Vector3d& direction,
                                   std::size_t digit) {
  const double flexion = -std::asin(std::clamp(direction.dot(neutral.back), -1.0, 1.0));
  if (std::abs(flexion) > kSteepestFlexion) {
    throw Error("hand joints: ", angle_names()[4 * digit + 1], " is ", flexion,
                " rad, expected a flatter hand: ", kSteepestFlexion, " at most");
  }
  const Eigen::Vector3d aside = neutral.axes[0].cross(neutral.along);
  return {std::atan2(direction.dot(aside), direction.dot(neutral.along)), flexion};
}

/// The same for the thumb, whose abduction turns about an axis in the palm's plane.
Eigen::Vector2d thumb_root_angles(const NeutralDigit& neutral, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d& axis = neutral.axes[0];
  // Abduction keeps the part along its axis, which flexion in the palm's plane must have made.
  const Eigen::Vector3d aside = neutral.axes[1].cross(neutral.along);
  const double flexion = std::atan2(axis.dot(neutral.along), -axis.dot(aside)) -
                         std::asin(std::clamp(direction.dot(axis), -1.0, 1.0));
  const Eigen::Vector3d flexed = std::cos(flexion) * neutral.along + std::sin(flexion) * aside;
  const Eigen::Vector3d across = (flexed - flexed.dot(axis) * axis).normalized();
  return {std::atan2(direction.dot(axis.cross(across)), direction.dot(across)), flexion};
}

/// The axis of a digit's outer joints: neutral where they are straight, that of the plane which
/// they are bent in where they are bent.
Eigen::Vector3d outer_axis(const NeutralDigit& neutral, const Eigen::Vector3d& middle,
                           const Eigen::Vector3d& distal) {
  Eigen::Vector3d bend = neutral.along.cross(middle) + middle.cross(distal);
  if (bend.dot(neutral.axes[2]) < 0.0) bend = -bend;
  const Eigen::Vector3d axis = bend + 0.2 * neutral.axes[2];
  return (axis - axis.dot(neutral.along) * neutral.along).normalized();
}

void add_digit(const Keypoints& right, std::size_t digit, FoundSkeleton& found) {
  const NeutralDigit neutral = neutral_digit(digit);
  const std::size_t first = 1 + 4 * digit, angle = 4 * digit;
  std::array<Eigen::Vector3d, 3> bones;
  for (std::size_t i = 0; i < 3; ++i) bones[i] = right[first + i + 1] - right[first + i];

  const Eigen::Vector2d root = digit == 0
                                   ? thumb_root_angles(neutral, bones[0].normalized())
                                   : finger_root_angles(neutral, bones[0].normalized(), digit);
  Eigen::Quaterniond turned =
      so3_exp(neutral.axes[0] * root[0]) * so3_exp(neutral.axes[1] * root[1]);
  const Eigen::Quaterniond back = turned.conjugate();
  const Eigen::Vector3d axis =
      outer_axis(neutral, (back * bones[1]).normalized(), (back * bones[2]).normalized());
  const Eigen::Vector3d palmar = axis.cross(neutral.along);

  found.skeleton.axes[angle] = neutral.axes[0];
  found.skeleton.axes[angle + 1] = neutral.axes[1];
  found.angles.segment<2>(static_cast<Eigen::Index>(angle)) = root;
  Eigen::Vector3d joint = right[first];
  found.skeleton.keypoints[first] = joint;
  joint += bones[0].norm() * neutral.along;
  found.skeleton.keypoints[first + 1] = joint;
  for (std::size_t i = 1; i < 3; ++i) {
    // Unbending takes out the turn about the axis and leaves what lies along it.
    const Eigen::Vector3d bone = turned.conjugate() * bones[i];
    const double bend = std::atan2(bone.dot(palmar), bone.dot(neutral.along));
    const double straight = std::hypot(bone.dot(palmar), bone.dot(neutral.along));
    joint += bone.dot(axis) * axis + straight * neutral.along;
    turned = turned * so3_exp(axis * bend);
    found.skeleton.keypoints[first + i + 1] = joint;
    found.skeleton.axes[angle + i + 1] = axis;
    found.angles[static_cast<Eigen::Index>(angle + i + 1)] = bend;
  }
}

}  // namespace

FoundSkeleton skeleton_from_keypoints(const Keypoints& keypoints, Side side) {
  check_bones(keypoints);
  FoundSkeleton found;
  found.source_from_hand = frame_of_palm(keypoints, side);
  Keypoints right;
  const Rigid3d hand_from_source = found.source_from_hand.inverse();
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    right[k] = hand_from_source * keypoints[k];
    if (side == Side::left) right[k].x() = -right[k].x();
  }
  check_side(right, side);
  found.skeleton.keypoints[0].setZero();
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) add_digit(right, digit, found);
  if (side == Side::left) found.skeleton = mirrored(found.skeleton);
  return found;
}

}  // namespace tegata
