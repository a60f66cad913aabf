// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "tegata/hand/skeleton.h"

namespace tegata {

enum class Sex { female, male };

/// The sizes of a hand. Defaults are those of the mean adult, women and men together; sources are
/// beside the numbers in hand_shape.cpp. What is a factor multiplies what goes with the size above
/// it, so that a hand of factors 1 is fully described by the first sizes.
struct HandShape {
  double length = 0.189;           ///< wrist crease to the tip of the middle finger, factors 1 [m]
  double palm_breadth = 0.084;     ///< at the finger knuckles; the digits' thickness goes with it
  double palm_thickness = 0.0305;  ///< at the finger knuckles [m]
  double finger_thickness = 1.0;   ///< factor on all digits' radii
  double forearm_length = 0.05;    ///< of the stump beyond the wrist [m]
  double palm_length = 1.0;        ///< factor on the wrist's distance to the digits' first joints
  /// Factors on the wrist's distance to the knuckles of the fingers, from index to little.
  std::array<double, kDigitCount - 1> metacarpal_lengths = {1.0, 1.0, 1.0, 1.0};
  std::array<double, kDigitCount> digit_thickness = {1.0, 1.0, 1.0, 1.0, 1.0};  ///< factors
  /// Factors on the bones' lengths, in the order of bone_names() after the palm.
  std::array<double, kBoneCount - 1> bone_lengths = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
                                                     1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

  /// The hand all of whose sizes are at one percentile (above 0, below 100) of adult women or men.
  /// Throws Error for other percentiles.
  static HandShape percentile(double percentile, Sex sex);
};

/// Throws Error naming a size that is not that of a human hand: smaller than half or larger than
/// one and a half times the default (the forearm: 0.02 m to 0.3 m; palm_length,
/// metacarpal_lengths and bone_lengths: 0.6 to 1.5).
void check_shape(const HandShape& shape);

/// The length of a bone other than the palm, between joints or to the tip [m].
double bone_length(const HandShape& shape, int bone);

/// The joints of a right hand of this shape.
Skeleton right_skeleton(const HandShape& shape);

/// How a digit of a right hand lies at zero angles, whatever its size.
struct NeutralDigit {
  Eigen::Vector3d along;                ///< from its first joint to its tip
  Eigen::Vector3d back;                 ///< out of the nail's side
  std::array<Eigen::Vector3d, 4> axes;  ///< of its angles, as in Skeleton
};
/// Digits from the thumb (0) to the little finger (4).
NeutralDigit neutral_digit(std::size_t digit);

/// The angles that the built-in surface is made at, whatever its shape: fingers spread so that they
/// do not touch, and bent about half as far as they go, which is where skinning has the least way
/// to go to either end.
const JointAngles& meshing_angles();

}  // namespace tegata
