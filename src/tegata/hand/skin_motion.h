// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tegata/hand/hand_model.h"

namespace tegata {

/// What a pose does to the rows of a surface (SkinRows), in plain numbers: world axes, but about
/// the hand's origin, so that a hand far from the world's origin loses nothing.
class SkinMotion {
 public:
  /// Has no motion before move_to().
  explicit SkinMotion(const HandModel& model);

  void move_to(const HandPose& pose);

  /// A bone's matrix, from the rest surface to the axes above.
  struct Bone {
    std::array<std::array<double, 3>, 3> turn;  ///< rows
    std::array<double, 3> shift;
  };
  /// What an angle turns about.
  struct Axis {
    std::array<double, 3> center, direction;
  };
  /// What moves the rows of a digit: the palm and its own bones outwards, and its angles. The first
  /// two axes share their centre.
  struct Digit {
    std::array<Bone, 4> bones;
    std::array<Axis, 4> axes;
  };
  const Digit& digit(std::size_t digit) const { return digits_[digit]; }
  const Bone& palm() const { return digits_[0].bones[0]; }
  /// The hand's origin, in world coordinates [m].
  const Eigen::Vector3d& origin() const { return origin_; }

 private:
  Skeleton skeleton_;
  std::array<Bone, kBoneCount> zero_from_rest_;
  std::array<Digit, kDigitCount> digits_ = {};
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

}  // namespace tegata
