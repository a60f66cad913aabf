// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/hand_solid.h"

#include <algorithm>
#include <cmath>

namespace tegata {
namespace {

using Transforms = std::array<Rigid3d, kBoneCount>;

constexpr double kMillimetre = 0.001;
constexpr double kPalmBlend =
    0.008;  // [m]: how far from each other two parts begin to run together
constexpr double kDigitBlend = 0.003;
constexpr double kRootBlend = 0.007;  // of a digit with the palm
constexpr double kEndBlend = 0.008;   // of the forearm with where it is cut off

/// The larger of two, rounded where they differ by less than `blend`; not steeper than they are.
double smooth_maximum(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  return std::max(a, b) + overlap * overlap / (4.0 * blend);
}

/// A part of the palm in the mean hand [mm]: a cone, flattened in z.
struct PalmPart {
  double ax, ay, az, radius_a;
  double bx, by, bz, radius_b;
  double flatness;
};

// Drawn, on the joints of hand_shape.cpp, to the breadths and depths in HandShape: a breadth of 84
// and a thickness of 30 across the knuckles, a wrist of 58 by 40 (mean adult: DIN 33402-2), 48
// through the ball of the thumb (Pheasant 1986).
constexpr PalmPart kPalmParts[] = {
    // the metacarpals
    {-12.0, 26.0, 2.5, 11.0, -21.5, 84.0, -1.5, 11.2, 1.0},
    {-2.0, 27.0, 3.0, 11.5, 0.0, 84.0, 0.0, 11.5, 1.0},
    {8.0, 26.0, 2.0, 11.0, 17.3, 77.0, -1.5, 11.0, 1.0},
    {16.0, 23.0, 0.0, 11.0, 34.0, 69.0, -5.0, 10.2, 1.0},
    // the flesh in front of them, thickest as pads behind the fingers
    {-17.0, 48.0, -6.5, 8.0, -20.5, 86.0, -7.5, 10.2, 1.0},
    {-1.0, 44.0, -6.0, 8.0, 0.0, 88.0, -7.5, 10.4, 1.0},
    {11.0, 40.0, -7.0, 9.0, 17.5, 81.0, -8.5, 9.8, 1.0},
    {24.0, 34.0, -8.0, 10.0, 33.0, 74.0, -10.0, 9.0, 1.0},
    // the eminences of the little finger and, as far as it stays behind, of the thumb
    {20.5, 14.0, -9.0, 13.0, 31.0, 45.0, -8.5, 13.5, 1.0},
    {-14.0, 9.0, -9.5, 13.0, -15.0, 42.0, -8.0, 10.5, 1.0},
    // the wrist's bones
    {0.0, 2.0, -1.0, 25.0, 2.0, 26.0, -2.0, 27.0, 0.64},
};

// The webs between the fingers, in front of and between their first joints.
constexpr PalmPart kWebParts[] = {
    {-17.0, 94.0, -7.0, 7.0, -4.0, 96.0, -7.0, 7.0, 0.9},
    {-11.5, 86.0, -4.0, 8.0, -11.2, 99.5, -9.0, 6.0, 0.9},
    {4.0, 95.0, -7.0, 7.0, 15.0, 90.0, -8.0, 7.0, 0.9},
    {9.0, 84.0, -4.0, 8.0, 10.3, 98.5, -9.5, 6.0, 0.9},
    {20.0, 87.0, -8.0, 6.5, 31.0, 80.0, -10.0, 6.5, 0.9},
    {25.5, 76.0, -6.0, 7.5, 27.3, 89.5, -11.0, 5.5, 0.9},
};

/// A digit's half breadths in the mean hand [mm]: at its first joint, the next two and in the tip.
/// At the index finger's second joint and the thumb's third as in Pheasant 1986 (19.5 and 21 mm
/// across), the others within the ranges of finger breadths in Greiner, Hand anthropometry of U.S.
/// Army personnel, 1991, women and men together.
constexpr double kRadii[kDigitCount][4] = {{12.5, 10.8, 10.2, 7.4},
                                           {11.0, 9.7, 8.4, 6.8},
                                           {11.2, 9.9, 8.6, 7.0},
                                           {10.5, 9.3, 8.0, 6.6},
                                           {9.4, 8.1, 7.0, 5.9}};
constexpr double kDigitFlatness = 0.88;  // depth to breadth
constexpr double kNailFlatness = 0.80;   // the same at the tip
// The last bone's line ends so far below the middle of the tip without its pad [mm]: at the end of
// the bone the nail lies on half its thickness, 2 mm, and 2.4 mm of nail bed (Moreira et al.,
// Radiology of clubbed fingers, Clinical Anatomy 21, 2008).
constexpr double kNailRise = 0.5;
constexpr double kWaist = 0.93;  // breadth halfway between joints to that of a cone

}  // namespace

RoundedCone::RoundedCone(const Ends& ends, const Eigen::Vector3d& flat, double flatness)
    : a_(ends.a), flat_(flat), radius_(ends.radius_a) {
  // In space stretched along `flat` the cone is round.
  stretch_ = 1.0 / flatness - 1.0;
  const Eigen::Vector3d way = ends.b - ends.a;
  const Eigen::Vector3d stretched = way + flat * (flat.dot(way) * stretch_);
  length_ = stretched.norm();
  along_ = stretched / length_;
  taper_ = (ends.radius_b - ends.radius_a) / length_;
  lean_ = taper_ / std::sqrt(1.0 - taper_ * taper_);
  steepness_ = std::min(flatness, 1.0);
  for (const auto& [center, radius] :
       {std::pair(ends.a, ends.radius_a), std::pair(ends.b, ends.radius_b)}) {
    const double reach = radius * std::max(flatness, 1.0);
    box_.extend(Eigen::Vector3d(center.array() - reach));
    box_.extend(Eigen::Vector3d(center.array() + reach));
  }
}

double RoundedCone::field(const Eigen::Vector3d& point) const {
  Eigen::Vector3d offset = point - a_;
  offset += flat_ * (flat_.dot(offset) * stretch_);
  const double axial = offset.dot(along_);
  const double radial = std::sqrt(std::max(offset.squaredNorm() - axial * axial, 0.0));
  // The ball that comes nearest is not the one beside the point where the radius changes.
  const double ball = std::clamp(axial + radial * lean_, 0.0, length_);
  return (radius_ + taper_ * ball - std::hypot(axial - ball, radial)) * steepness_;
}

HandSolid::HandSolid(const Skeleton& skeleton, const JointAngles& angles) {
  const Transforms transforms = bone_transforms(skeleton, angles);
  add_palm();
  add_thumb(skeleton, transforms);
  for (std::size_t digit = 1; digit < kDigitCount; ++digit) {
    add_finger(skeleton, transforms, digit);
  }
}

void HandSolid::add_palm() {
  const Eigen::Vector3d dorsal = Eigen::Vector3d::UnitZ();
  const auto add = [&](const PalmPart& part) {
    palm_.emplace_back(RoundedCone::Ends{kMillimetre * Eigen::Vector3d(part.ax, part.ay, part.az),
                                         kMillimetre * Eigen::Vector3d(part.bx, part.by, part.bz),
                                         kMillimetre * part.radius_a, kMillimetre * part.radius_b},
                       dorsal, part.flatness);
  };
  for (const PalmPart& part : kPalmParts) add(part);
  for (const PalmPart& part : kWebParts) add(part);
  // The forearm, on past where it is cut off.
  forearm_end_ = -HandShape().forearm_length;
  const double wrist = 26.0 * kMillimetre, beyond = forearm_end_ - wrist;
  palm_.emplace_back(
      RoundedCone::Ends{{0.0, 0.0, -0.001}, {0.001, beyond, 0.0}, wrist, wrist - 0.05 * beyond},
      dorsal, 0.69);
}

void HandSolid::add_finger(const Skeleton& skeleton, const Transforms& transforms,
                           std::size_t digit) {
  const Eigen::Vector3d flexion = skeleton.axes[4 * digit + 2];
  for (std::size_t i = 0; i < 3; ++i) {
    const Rigid3d& bone = transforms[1 + 3 * digit + i];
    const Eigen::Vector3d& near = skeleton.keypoints[1 + 4 * digit + i];
    const Eigen::Vector3d& far = skeleton.keypoints[2 + 4 * digit + i];
    const Eigen::Vector3d along = (far - near).normalized();
    const Eigen::Vector3d palmar = flexion.cross(along);
    const double near_radius = kMillimetre * kRadii[digit][i];
    const double far_radius = kMillimetre * kRadii[digit][i + 1];
    const auto add = [&](const RoundedCone::Ends& ends, double flatness) {
      digits_[digit].emplace_back(
          RoundedCone::Ends{bone * ends.a, bone * ends.b, ends.radius_a, ends.radius_b},
          bone.rotation * palmar, flatness);
    };
    const bool is_last = i == 2;
    const Eigen::Vector3d end = is_last ? Eigen::Vector3d(far - far_radius * along) : far;
    // The bone, thickest at the joints; the last one rises towards the nail.
    const Eigen::Vector3d risen = end - (is_last ? kNailRise : 0.0) * kMillimetre * palmar;
    const Eigen::Vector3d middle = 0.5 * (near + risen);
    const double waist = kWaist * 0.5 * (near_radius + far_radius);
    const double flatness = is_last ? kNailFlatness : kDigitFlatness;
    add({near, middle, near_radius, waist}, kDigitFlatness);
    add({middle, risen, waist, far_radius}, flatness);
    // The flesh on its palmar side.
    const Eigen::Vector3d flesh = 2.4 * kMillimetre * palmar, way = end - near;
    add({near + 0.34 * way + flesh, near + (is_last ? 0.9 : 0.66) * way + flesh, 0.9 * near_radius,
         (is_last ? 0.97 : 0.93) * far_radius},
        kDigitFlatness);
  }
}

void HandSolid::add_thumb(const Skeleton& skeleton, const Transforms& transforms) {
  add_finger(skeleton, transforms, 0);
  const Rigid3d& metacarpal = transforms[1];
  const Eigen::Vector3d& near = skeleton.keypoints[1];
  const Eigen::Vector3d way = skeleton.keypoints[2] - near;
  const Eigen::Vector3d flexion = skeleton.axes[2];
  const Eigen::Vector3d palmar = flexion.cross(way.normalized());
  // The thumb's eminence.
  digits_[0].emplace_back(
      RoundedCone::Ends{metacarpal * (near + 0.15 * way + 6.5 * kMillimetre * palmar),
                        metacarpal * (near + 0.62 * way + 5.0 * kMillimetre * palmar),
                        16.5 * kMillimetre, 14.0 * kMillimetre},
      metacarpal.rotation * palmar, 1.0);
  // The web from the thumb to the index finger's metacarpal, a fan of folds.
  const Eigen::Vector3d index_base = kMillimetre * Eigen::Vector3d(-14.0, 40.0, -3.0);
  const Eigen::Vector3d index_way = 0.68 * (skeleton.keypoints[5] - index_base);
  for (const double part : {0.25, 0.5, 0.75, 1.0}) {
    const double radius = (10.5 - 3.0 * part) * kMillimetre;
    palm_.emplace_back(RoundedCone::Ends{metacarpal * (near + (0.3 + 0.45 * part) * way),
                                         index_base + part * index_way, radius, radius},
                       metacarpal.rotation * flexion, 1.0);
  }
}

double HandSolid::field(const Eigen::Vector3d& point) const {
  double palm = palm_.front().field(point);
  for (std::size_t i = 1; i < palm_.size(); ++i) {
    palm = smooth_maximum(palm, palm_[i].field(point), kPalmBlend);
  }
  double hand = palm;
  for (const std::vector<RoundedCone>& parts : digits_) {
    double digit = parts.front().field(point);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      digit = smooth_maximum(digit, parts[i].field(point), kDigitBlend);
    }
    hand = std::max(hand, smooth_maximum(palm, digit, kRootBlend));
  }
  return -smooth_maximum(-hand, forearm_end_ - point.y(), kEndBlend);
}

Eigen::AlignedBox3d HandSolid::box() const {
  Eigen::AlignedBox3d box;
  for (const RoundedCone& part : palm_) box.extend(part.box());
  for (const std::vector<RoundedCone>& parts : digits_) {
    for (const RoundedCone& part : parts) box.extend(part.box());
  }
  // Running together swells the parts by less than what the widest blend adds to two of them.
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kPalmBlend);
  box = Eigen::AlignedBox3d(box.min() - margin, box.max() + margin);
  box.min().y() = std::max(box.min().y(), forearm_end_ - kPalmBlend);
  return box;
}

}  // namespace tegata
