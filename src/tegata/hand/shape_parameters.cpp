// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/shape_parameters.h"

#include "tegata/base/text.h"

namespace tegata {
namespace {

// Where parameters begin.
constexpr int kLength = 0, kPalmBreadth = 1, kPalmThickness = 2, kPalmLength = 3,
              kFingerThickness = 4, kDigitThickness = 5, kBoneLengths = 10,
              kMetacarpalLengths = kBoneLengths + kBoneCount - 1;
constexpr int kBoneDrivers = 0;

// Standard deviations. Length: women and men of Gordon et al. 1989 (180.5 and 193.8 mm, 9.7 and 9.8
// within each sex) as one population. The others are of ratios. Palm breadth: the same survey's
// breadths (79.4 and 90.4 mm, 3.8 and 4.2) against length, with their correlation taken as 0.6.
// Palm thickness, palm length and finger thickness: from Pheasant 1986 (28 and 33 mm, 2; 97 and 107
// mm, 5 and 6; index finger 18 and 21 mm, 1), rounded up. Single digits, bones and knuckles: what
// Buchholz et al. 1992 leave unexplained by the length of the hand, rounded.
constexpr double kLengthDeviation = 0.012;
constexpr double kBreadthDeviation = 0.045;
constexpr double kThicknessDeviation = 0.08;
constexpr double kPalmLengthDeviation = 0.03;
constexpr double kFingerThicknessDeviation = 0.06;
constexpr double kDigitDeviation = 0.04;
constexpr double kBoneDeviation = 0.05;
constexpr double kOuterBoneDeviation = 0.07;  // of the thumb and of distal phalanges
constexpr double kMetacarpalDeviation = 0.03;
// Of the limits, in deviations: proportions may lie where no adult's do (proportion_prior.h), sizes
// would leave what check_shape() lets pass.
constexpr double kWidestSize = 4.0, kWidestProportion = 8.0;
constexpr double kLeastFactor = 0.6, kMostFactor = 1.5;

double relative_length(const ShapeParameters& parameters) {
  return parameters[kLength] / HandShape().length;
}

}  // namespace

const std::array<std::string, kShapeParameterCount>& shape_parameter_names() {
  static const std::array<std::string, kShapeParameterCount> names = [] {
    std::array<std::string, kShapeParameterCount> made = {
        "length",           "palm_breadth",    "palm_thickness",  "palm_length",
        "finger_thickness", "thumb_thickness", "index_thickness", "middle_thickness",
        "ring_thickness",   "little_thickness"};
    for (std::size_t bone = 1; bone < kBoneCount; ++bone) {
      made[kBoneLengths + bone - 1] = text(bone_names()[bone], "_length");
    }
    std::size_t next = kMetacarpalLengths;
    for (const char* finger : {"index", "middle", "ring", "little"}) {
      made[next++] = text(finger, "_metacarpal_length");
    }
    return made;
  }();
  return names;
}

const ShapePrior& shape_prior() {
  static const ShapePrior prior = [] {
    ShapePrior made;
    made.mean = parameters_of_shape(HandShape());
    made.deviation[kLength] = kLengthDeviation;
    made.deviation[kPalmBreadth] = kBreadthDeviation;
    made.deviation[kPalmThickness] = kThicknessDeviation;
    made.deviation[kPalmLength] = kPalmLengthDeviation;
    made.deviation[kFingerThickness] = kFingerThicknessDeviation;
    made.deviation.segment<kDigitCount>(kDigitThickness).setConstant(kDigitDeviation);
    for (int bone = 1; bone < kBoneCount; ++bone) {
      const bool is_outer = bone <= 3 || bone % 3 == 0;
      made.deviation[kBoneLengths + bone - 1] = is_outer ? kOuterBoneDeviation : kBoneDeviation;
    }
    made.deviation.segment<kDigitCount - 1>(kMetacarpalLengths).setConstant(kMetacarpalDeviation);
    ShapeParameters widest = kWidestProportion * made.deviation;
    widest.head<kPalmLength>() = kWidestSize * made.deviation.head<kPalmLength>();
    made.lower = (made.mean - widest).cwiseMax(kLeastFactor * made.mean);
    made.upper = (made.mean + widest).cwiseMin(kMostFactor * made.mean);
    return made;
  }();
  return prior;
}

HandShape shape_from_parameters(const ShapeParameters& parameters) {
  const double relative = relative_length(parameters);
  HandShape shape;
  shape.length = parameters[kLength];
  shape.palm_breadth *= relative * parameters[kPalmBreadth];
  shape.palm_thickness *= relative * parameters[kPalmThickness];
  shape.forearm_length *= relative;
  shape.palm_length = parameters[kPalmLength];
  shape.finger_thickness = parameters[kFingerThickness];
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    shape.digit_thickness[digit] = parameters[kDigitThickness + static_cast<int>(digit)];
  }
  for (std::size_t bone = 0; bone < shape.bone_lengths.size(); ++bone) {
    shape.bone_lengths[bone] = parameters[kBoneLengths + static_cast<int>(bone)];
  }
  for (std::size_t finger = 0; finger < shape.metacarpal_lengths.size(); ++finger) {
    shape.metacarpal_lengths[finger] = parameters[kMetacarpalLengths + static_cast<int>(finger)];
  }
  return shape;
}

ShapeParameters parameters_of_shape(const HandShape& shape) {
  const HandShape mean;
  const double relative = shape.length / mean.length;
  ShapeParameters parameters;
  parameters[kLength] = shape.length;
  parameters[kPalmBreadth] = shape.palm_breadth / (mean.palm_breadth * relative);
  parameters[kPalmThickness] = shape.palm_thickness / (mean.palm_thickness * relative);
  parameters[kPalmLength] = shape.palm_length;
  parameters[kFingerThickness] = shape.finger_thickness;
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    parameters[kDigitThickness + static_cast<int>(digit)] = shape.digit_thickness[digit];
  }
  for (std::size_t bone = 0; bone < shape.bone_lengths.size(); ++bone) {
    parameters[kBoneLengths + static_cast<int>(bone)] = shape.bone_lengths[bone];
  }
  for (std::size_t finger = 0; finger < shape.metacarpal_lengths.size(); ++finger) {
    parameters[kMetacarpalLengths + static_cast<int>(finger)] = shape.metacarpal_lengths[finger];
  }
  return parameters;
}

ShapeDrivers drivers_of_shape(const HandShape& shape) {
  const HandShape mean;
  ShapeDrivers drivers;
  for (int bone = 1; bone < kBoneCount; ++bone) {
    drivers[kBoneDrivers + bone - 1] = bone_length(shape, bone);
  }
  const double breadth = shape.palm_breadth / mean.palm_breadth;
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    drivers[kDigitDrivers + static_cast<int>(digit)] =
        breadth * shape.finger_thickness * shape.digit_thickness[digit];
  }
  drivers[kPalmDrivers] = breadth;
  drivers[kPalmDrivers + 1] = shape.palm_length * shape.length / mean.length;
  drivers[kPalmDrivers + 2] = shape.palm_thickness / mean.palm_thickness;
  drivers[kForearmDriver] = shape.forearm_length / mean.forearm_length;
  for (std::size_t finger = 0; finger < shape.metacarpal_lengths.size(); ++finger) {
    drivers[kKnuckleDrivers + static_cast<int>(finger)] =
        drivers[kPalmDrivers + 1] * shape.metacarpal_lengths[finger];
  }
  return drivers;
}

Eigen::Matrix<double, kShapeDriverCount, kShapeParameterCount> driver_jacobian(
    const ShapeParameters& parameters) {
  Eigen::Matrix<double, kShapeDriverCount, kShapeParameterCount> jacobian;
  jacobian.setZero();
  const ShapeDrivers drivers = drivers_of_shape(shape_from_parameters(parameters));
  // Every driver is a product of parameters, the length among them.
  const auto add = [&](int driver, int parameter) {
    jacobian(driver, parameter) = drivers[driver] / parameters[parameter];
  };
  for (int driver = 0; driver < kShapeDriverCount; ++driver) add(driver, kLength);
  for (int bone = 0; bone < kBoneCount - 1; ++bone) add(kBoneDrivers + bone, kBoneLengths + bone);
  for (int digit = 0; digit < kDigitCount; ++digit) {
    add(kDigitDrivers + digit, kPalmBreadth);
    add(kDigitDrivers + digit, kFingerThickness);
    add(kDigitDrivers + digit, kDigitThickness + digit);
  }
  add(kPalmDrivers, kPalmBreadth);
  add(kPalmDrivers + 1, kPalmLength);
  add(kPalmDrivers + 2, kPalmThickness);
  for (int finger = 0; finger < kDigitCount - 1; ++finger) {
    add(kKnuckleDrivers + finger, kPalmLength);
    add(kKnuckleDrivers + finger, kMetacarpalLengths + finger);
  }
  return jacobian;
}

}  // namespace tegata
