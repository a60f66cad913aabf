// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Joint positions and link lengths as fractions of the hand's length and breadth: Buchholz,
// Armstrong, Goldstein, Anthropometric data for describing the kinematics of the human hand,
// Ergonomics 35, 1992. They are distances between centres of rotation, which lie in the heads of
// the bones; lengths of the bones themselves (such as Buryanov and Kotiuk, Proportions of hand
// segments, Int J Morphol 28, 2010) are shorter from the knuckle on.
#include "tegata/hand/hand_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"

namespace tegata {
namespace {

struct DigitProportions {
  double across, along;  // first joint from the wrist: radial x breadth, distal x length
  double links[3];       // x length; the last ends at the finger's tip
  double palmwards;      // first joint below the middle knuckle [x breadth]: the transverse arch
  double fan;            // direction at zero angles, from the middle finger towards ulnar [rad]
  double roll;           // of the digit's back, from dorsal towards ulnar [rad]
};

// The first two columns and the links are Buchholz's. The arch, the fan and the roll are drawn: so
// that straight fingers do not run into each other and bent ones point to the scaphoid.
constexpr DigitProportions kDigits[kDigitCount] = {
    {0.196, 0.073, {0.251, 0.196, 0.158}, 0.10, -48.0 * kDegree, -74.0 * kDegree},
    {0.251, 0.447, {0.245, 0.143, 0.097}, 0.012, -4.0 * kDegree, -4.0 * kDegree},
    {0.0, 0.446, {0.266, 0.170, 0.108}, 0.0, 0.0, 0.0},
    {-0.206, 0.409, {0.244, 0.165, 0.107}, 0.018, 4.5 * kDegree, 5.0 * kDegree},
    {-0.402, 0.368, {0.204, 0.117, 0.093}, 0.06, 10.0 * kDegree, 11.0 * kDegree},
};
// Wrist to the tip of the middle finger in the table above; the rest is the wrist's crease.
constexpr double kTabulatedLength = 0.446 + 0.266 + 0.170 + 0.108;

// The thumb's abduction turns about an axis nearer to the index metacarpal than the perpendicular
// to the thumb, so that it pronates the thumb as it goes: without it the pad would not come to face
// the fingers' pads, the model having no turn of its own for that (17 degrees in Cooney 1981).
constexpr double kThumbAxisTilt = 15.0 * kDegree;

struct Measured {
  double mean, deviation;  // [mm]
};

// Adults by sex. Hand length (wrist crease to tip) and breadth (at the knuckles): Gordon et al.,
// 1988 Anthropometric survey of U.S. Army personnel, Natick/TR-89/044. Thickness of the palm at the
// third metacarpal's head and breadth of the index finger at its PIP joint: Pheasant, Bodyspace,
// 1986, British adults. The percentile of a hand is taken for all of them at once, and all digits'
// thickness follows the index finger's.
struct Anthropometry {
  Measured length, breadth, thickness, index_breadth;
};
constexpr Anthropometry kWomen = {{180.5, 9.7}, {79.4, 3.8}, {28.0, 2.0}, {18.0, 1.0}};
constexpr Anthropometry kMen = {{193.8, 9.8}, {90.4, 4.2}, {33.0, 2.0}, {21.0, 1.0}};
// Of the built-in hand: finger_thickness 1 at the default palm_breadth.
constexpr double kIndexBreadth = 19.2;  // [mm]

/// The number of standard deviations that a share of a normal distribution lies below.
double normal_quantile(double share) {
  double low = -9.0, high = 9.0;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::numbers::sqrt2) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Eigen::Vector3d turned(const Eigen::Vector3d& vector, const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis) * vector;
}

void check_size(std::string_view name, double got, double least, double most) {
  if (!(got >= least && got <= most)) {
    throw Error("hand shape: ", name, " is ", got, ", expected ", least, " to ", most);
  }
}

}  // namespace

HandShape HandShape::percentile(double percentile, Sex sex) {
  if (!(percentile > 0.0 && percentile < 100.0)) {
    throw Error("hand shape: percentile is ", percentile, ", expected above 0 and below 100");
  }
  const Anthropometry& adults = sex == Sex::female ? kWomen : kMen;
  const double deviations = normal_quantile(0.01 * percentile);
  const auto size = [&](const Measured& measured) {
    return 0.001 * (measured.mean + deviations * measured.deviation);
  };
  HandShape shape;
  shape.length = size(adults.length);
  shape.palm_breadth = size(adults.breadth);
  shape.palm_thickness = size(adults.thickness);
  shape.finger_thickness = size(adults.index_breadth) /
                           (0.001 * kIndexBreadth * shape.palm_breadth / HandShape().palm_breadth);
  return shape;
}

void check_shape(const HandShape& shape) {
  const HandShape mean;
  check_size("length", shape.length, 0.5 * mean.length, 1.5 * mean.length);
  check_size("palm_breadth", shape.palm_breadth, 0.5 * mean.palm_breadth, 1.5 * mean.palm_breadth);
  check_size("palm_thickness", shape.palm_thickness, 0.5 * mean.palm_thickness,
             1.5 * mean.palm_thickness);
  check_size("finger_thickness", shape.finger_thickness, 0.5, 1.5);
  check_size("forearm_length", shape.forearm_length, 0.02, 0.3);
  check_size("palm_length", shape.palm_length, 0.6, 1.5);
  for (const double factor : shape.metacarpal_lengths) {
    check_size("metacarpal_lengths", factor, 0.6, 1.5);
  }
  for (const double thickness : shape.digit_thickness) {
    check_size("digit_thickness", thickness, 0.5, 1.5);
  }
  for (const double factor : shape.bone_lengths) check_size("bone_lengths", factor, 0.6, 1.5);
}

NeutralDigit neutral_digit(std::size_t digit) {
  const DigitProportions& part = kDigits[digit];
  const Eigen::Vector3d dorsal = Eigen::Vector3d::UnitZ();
  NeutralDigit neutral;
  neutral.along = Eigen::Vector3d(std::sin(part.fan), std::cos(part.fan), 0.0);
  neutral.back = turned(dorsal, neutral.along, part.roll);
  // Turns `along` to the digit's palmar side.
  const Eigen::Vector3d flexion = neutral.back.cross(neutral.along);
  // About the digit's own back: towards radial is a right-handed turn.
  neutral.axes = {digit <= 2 ? neutral.back : Eigen::Vector3d(-neutral.back), flexion, flexion,
                  flexion};
  if (digit == 0) {
    neutral.axes[0] = turned(dorsal.cross(neutral.along), dorsal, kThumbAxisTilt);
    neutral.axes[1] = -dorsal;
  }
  return neutral;
}

double bone_length(const HandShape& shape, int bone) {
  const auto index = static_cast<std::size_t>(bone - 1);
  return shape.bone_lengths[index] * kDigits[index / 3].links[index % 3] * shape.length /
         kTabulatedLength;
}

Skeleton right_skeleton(const HandShape& shape) {
  check_shape(shape);
  const double length = shape.palm_length * shape.length / kTabulatedLength;
  const double breadth = shape.palm_breadth;
  Skeleton skeleton;
  skeleton.side = Side::right;
  skeleton.keypoints[0].setZero();
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const auto d = static_cast<std::size_t>(digit);
    const DigitProportions& part = kDigits[d];
    const NeutralDigit neutral = neutral_digit(d);
    const double metacarpal = digit == 0 ? 1.0 : shape.metacarpal_lengths[d - 1];
    Eigen::Vector3d joint(-part.across * breadth, part.along * length * metacarpal,
                          -part.palmwards * breadth);
    for (int i = 0; i < 4; ++i) {
      const auto within = static_cast<std::size_t>(i);
      skeleton.keypoints[1 + 4 * d + within] = joint;
      skeleton.axes[4 * d + within] = neutral.axes[within];
      if (i < 3) joint += bone_length(shape, 1 + 3 * digit + i) * neutral.along;
    }
  }
  return skeleton;
}

const JointAngles& meshing_angles() {
  static const JointAngles angles = [] {
    JointAngles degrees;
    degrees << 25.0, 6.0, 22.0, 28.0,  // thumb
        11.0, 26.0, 42.0, 28.0,        // index
        0.0, 26.0, 42.0, 28.0,         // middle
        9.0, 26.0, 42.0, 28.0,         // ring
        16.0, 26.0, 42.0, 28.0;        // little
    return JointAngles(degrees * kDegree);
  }();
  return angles;
}

}  // namespace tegata
