// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "tegata/hand/hand_shape.h"

namespace tegata {

/// Length, palm breadth, palm thickness, palm length, finger thickness, five digits' thickness,
/// fifteen bones' lengths, where four fingers' knuckles lie.
inline constexpr int kShapeParameterCount = 10 + kBoneCount - 1 + kDigitCount - 1;

/// The shape of a hand as an estimator moves it: "length" in metres, all others factors of about 1
/// on what goes with the length, so that a change of scale is a change of the first alone.
using ShapeParameters = Eigen::Matrix<double, kShapeParameterCount, 1>;

/// "length", "palm_breadth", "palm_thickness", "palm_length", "finger_thickness",
/// "thumb_thickness" ... "little_thickness", "thumb_metacarpal_length" ... "little_distal_length",
/// "index_metacarpal_length" ... "little_metacarpal_length".
const std::array<std::string, kShapeParameterCount>& shape_parameter_names();

/// What is known of a hand before it is seen. The deviations are independent of each other: what
/// hands have in common is in "length" and "finger_thickness".
struct ShapePrior {
  ShapeParameters mean, deviation;
  ShapeParameters lower, upper;  ///< beyond these nothing that is like a hand is
};
const ShapePrior& shape_prior();

/// The shape of these parameters; the forearm's length goes with the hand's.
HandShape shape_from_parameters(const ShapeParameters& parameters);
/// The parameters of a shape, whatever its forearm.
ShapeParameters parameters_of_shape(const HandShape& shape);

/// The lengths that the surface moves with, each with what they are for the default HandShape: 15
/// bones [m], 5 digits' factors on radii, the palm's factors in x, y and z, the forearm's in y,
/// that of four fingers' knuckles in y. The surface and the joints of the built-in hand are linear
/// in them (shaped_hand.h).
inline constexpr int kShapeDriverCount = kBoneCount - 1 + kDigitCount + 3 + 1 + kDigitCount - 1;
/// Where in them they begin; the bones come first.
inline constexpr int kDigitDrivers = kBoneCount - 1, kPalmDrivers = kDigitDrivers + kDigitCount,
                     kForearmDriver = kPalmDrivers + 3, kKnuckleDrivers = kForearmDriver + 1;
using ShapeDrivers = Eigen::Matrix<double, kShapeDriverCount, 1>;
ShapeDrivers drivers_of_shape(const HandShape& shape);
/// d drivers / d parameters at a shape whose forearm goes with its length.
Eigen::Matrix<double, kShapeDriverCount, kShapeParameterCount> driver_jacobian(
    const ShapeParameters& parameters);

}  // namespace tegata
