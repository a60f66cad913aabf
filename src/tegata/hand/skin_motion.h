// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tegata/base/instruction_set.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// A number of each of so many digits, side by side in a register.
template <std::size_t kSize>
struct Digits {
  using Number [[gnu::vector_size(kSize * sizeof(double))]] = double;
  static constexpr std::size_t kCount = kSize;
};

/// What a pose does to the rows of a surface (SkinRows), in plain numbers: world axes, but about
/// the hand's origin, so that a hand far from the world's origin loses nothing.
class SkinMotion {
 public:
  /// Has no motion before move_to().
  explicit SkinMotion(const HandModel& model);

  /// Every instruction set gives the same bits; it must be supported.
  void move_to(const HandPose& pose, InstructionSet set = best_instruction_set());

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

  /// Numbers of the digits side by side, with room for a whole vector; the last digit's again
  /// there.
  using Lanes = std::array<double, 8>;
  using LaneVec = std::array<Lanes, 3>;
  /// What is known of the digits' joints and bones outwards at zero angles, in the hand's frame.
  struct alignas(64) Joints {
    std::array<LaneVec, 3> centers;
    std::array<LaneVec, 4> axes;  ///< of the angles
    struct Bone {
      std::array<LaneVec, 3> turn;  ///< rows, from the rest surface
      LaneVec shift;
    };
    std::array<Bone, 3> bones;
  };

 private:
  Joints joints_;
  Bone palm_from_rest_;
  std::array<Digit, kDigitCount> digits_ = {};
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

}  // namespace tegata
