// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_motion.h"

namespace tegata {
namespace {

std::array<double, 3> plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// b_from_a times a's bone.
SkinMotion::Bone moved(const Rigid3d& b_from_a, const SkinMotion::Bone& bone) {
  const Eigen::Matrix3d turn = b_from_a.rotation.toRotationMatrix();
  SkinMotion::Bone product;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double x = turn(row, 0), y = turn(row, 1), z = turn(row, 2);
    for (std::size_t k = 0; k < 3; ++k) {
      product.turn[i][k] = x * bone.turn[0][k] + y * bone.turn[1][k] + z * bone.turn[2][k];
    }
    product.shift[i] =
        x * bone.shift[0] + y * bone.shift[1] + z * bone.shift[2] + b_from_a.translation[row];
  }
  return product;
}

}  // namespace

SkinMotion::SkinMotion(const HandModel& model) : skeleton_(model.skeleton) {
  constexpr Bone kNoMotion = {{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}, {}};
  const auto rest_from_zero = bone_transforms(model.skeleton, model.rest_angles);
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    zero_from_rest_[bone] = moved(rest_from_zero[bone].inverse(), kNoMotion);
  }
}

void SkinMotion::move_to(const HandPose& pose) {
  const Rigid3d turn{pose.world_from_hand.rotation, Eigen::Vector3d::Zero()};
  const auto from_zero = bone_transforms(skeleton_, pose.angles, turn);
  const auto axes = joint_axes(skeleton_, from_zero);
  const Bone palm = moved(from_zero[0], zero_from_rest_[0]);
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t bone = 3 * digit + i;
      digits_[digit].bones[i] = i == 0 ? palm : moved(from_zero[bone], zero_from_rest_[bone]);
      const JointAxis& axis = axes[4 * digit + i];
      digits_[digit].axes[i] = {plain(axis.center), plain(axis.direction)};
    }
  }
  origin_ = pose.world_from_hand.translation;
}

}  // namespace tegata
