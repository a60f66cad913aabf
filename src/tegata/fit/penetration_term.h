// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "tegata/fit/normal_equations.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// How thick the digits are: a rounded cylinder about each of their bones.
class DigitCapsules {
 public:
  explicit DigitCapsules(const HandModel& hand);

  /// Of bones 1 to 15 [m]: the median distance of what a bone moves from the bone; 0 where it moves
  /// nothing.
  double radius(int bone) const { return radii_[static_cast<std::size_t>(bone)]; }

 private:
  std::array<double, kBoneCount> radii_ = {};
};

struct PenetrationTermOptions {
  double standard_deviation = 0.001;  ///< of the depth of one digit in another [m]
  /// Digits may share so much of their thickness: flesh gives way, and cylinders are not digits.
  double free_share = 0.2;
};

/// Digits that are in each other's place, as one-sided quadratic terms of the angles: for each two
/// bones of different digits how much nearer to each other they are than their thickness allows.
/// Does not depend on the pose. `scale` multiplies lengths, see FitHand::scale; `weight` the term.
void add_penetration_term(const Skeleton& skeleton, const DigitCapsules& capsules,
                          const JointAngles& angles, const PenetrationTermOptions& options,
                          double scale, double weight, FrameEquations& equations);

}  // namespace tegata
