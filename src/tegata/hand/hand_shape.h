// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "tegata/hand/skeleton.h"

namespace tegata {

/// The sizes of a hand, all in metres. Defaults are those of the mean adult, from published
/// anthropometry (sources beside the numbers in hand_shape.cpp).
struct HandShape {
  double length = 0.189;        ///< wrist crease to the tip of the middle finger
  double palm_breadth = 0.084;  ///< at the finger knuckles; the digits' thickness goes with it
  double palm_thickness = 0.028;
  double finger_thickness = 1.0;  ///< scales all digits' radii
  double forearm_length = 0.05;   ///< of the stump beyond the wrist
};

/// Throws Error naming a size that is not that of a human hand: smaller than half or larger than
/// one and a half times the default (the forearm: 0.02 m to 0.3 m).
void check_shape(const HandShape& shape);

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

/// The angles that the built-in surface is made at: fingers spread so that they do not touch, the
/// thicker the more, and bent a little, which is where skinning has the least way to go to either
/// end.
JointAngles meshing_angles(const HandShape& shape);

}  // namespace tegata
