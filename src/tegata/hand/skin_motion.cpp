// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_motion.h"

namespace tegata {
namespace {

std::array<double, 3> plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

SkinMotion::Bone plain_bone(const Rigid3d& transform) {
  const Eigen::Matrix3d turn = transform.rotation.toRotationMatrix();
  return {{plain(turn.row(0)), plain(turn.row(1)), plain(turn.row(2))},
          plain(transform.translation)};
}

}  // namespace

SkinMotion::SkinMotion(const HandModel& model)
    : skeleton_(model.skeleton),
      zero_from_rest_(bone_transforms(model.skeleton, model.rest_angles)) {
  for (Rigid3d& transform : zero_from_rest_) transform = transform.inverse();
}

void SkinMotion::move_to(const HandPose& pose) {
  const Rigid3d turn{pose.world_from_hand.rotation, Eigen::Vector3d::Zero()};
  const auto from_zero = bone_transforms(skeleton_, pose.angles);
  const auto axes = joint_axes(skeleton_, from_zero);
  const Bone palm = plain_bone(turn * from_zero[0] * zero_from_rest_[0]);
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t bone = 3 * digit + i;
      digits_[digit].bones[i] =
          i == 0 ? palm : plain_bone(turn * from_zero[bone] * zero_from_rest_[bone]);
      const JointAxis& axis = axes[4 * digit + i];
      digits_[digit].axes[i] = {plain(turn.rotation * axis.center),
                                plain(turn.rotation * axis.direction)};
    }
  }
  origin_ = pose.world_from_hand.translation;
}

}  // namespace tegata
