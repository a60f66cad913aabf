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
// and a thickness of 28 across the knuckles, a wrist of 58 by 40 (mean adult: DIN 33402-2).
constexpr PalmPart kPalmParts[] = {
    // the metacarpals
    {-12.0, 26.0, 2.0, 11.0, -21.5, 85.0, -1.5, 11.5, 1.0},
    {-2.0, 27.0, 3.0, 11.5, 0.0, 85.0, 0.0, 11.5, 1.0},
    {8.0, 26.0, 2.0, 11.0, 17.3, 78.0, -1.5, 11.0, 1.0},
    {16.0, 23.0, 0.0, 11.0, 34.0, 70.0, -5.0, 10.2, 1.0},
    // the flesh in front of them
    {-15.0, 45.0, -6.0, 8.0, -20.0, 86.0, -6.5, 9.5, 1.0},
    {0.0, 40.0, -6.0, 8.5, 0.0, 87.0, -6.5, 9.5, 1.0},
    {10.0, 36.0, -6.0, 9.0, 17.5, 80.0, -7.0, 9.0, 1.0},
    {22.0, 30.0, -7.0, 10.0, 33.0, 73.0, -9.0, 8.5, 1.0},
    // the eminences of the little finger and, as far as it stays behind, of the thumb
    {20.0, 14.0, -8.0, 13.0, 32.0, 48.0, -8.0, 12.5, 1.0},
    {-9.0, 16.0, -10.0, 12.0, -12.0, 42.0, -8.0, 9.0, 1.0},
    // the wrist's bones
    {0.0, 2.0, -1.0, 25.0, 2.0, 26.0, -2.0, 27.0, 0.62},
};

// The webs between the fingers.
constexpr PalmPart kWebParts[] = {
    {-17.0, 94.0, -4.0, 7.5, -4.0, 96.0, -4.0, 7.5, 0.9},
    {4.0, 95.0, -4.0, 7.5, 15.0, 90.0, -5.0, 7.5, 0.9},
    {20.0, 88.0, -5.0, 7.0, 31.0, 81.0, -7.0, 6.5, 0.9},
};

/// A digit's half breadths in the mean hand [mm]: at its first joint, the next two and in the tip.
/// Within the ranges of finger breadths in Greiner, Hand anthropometry of U.S. Army personnel,
/// 1991, women and men together.
constexpr double kRadii[kDigitCount][4] = {{12.5, 11.2, 10.6, 8.6},
                                           {10.8, 9.6, 8.5, 7.2},
                                           {10.9, 9.8, 8.7, 7.4},
                                           {10.2, 9.2, 8.1, 7.0},
                                           {9.2, 8.1, 7.1, 6.2}};
constexpr double kDigitFlatness = 0.88;  // depth to breadth

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
  constexpr double scale = kMillimetre;
  const Eigen::Vector3d flexion = skeleton.axes[4 * digit + 1];
  for (std::size_t i = 0; i < 3; ++i) {
    const Rigid3d& bone = transforms[1 + 3 * digit + i];
    const Eigen::Vector3d& near = skeleton.keypoints[1 + 4 * digit + i];
    const Eigen::Vector3d& far = skeleton.keypoints[2 + 4 * digit + i];
    const Eigen::Vector3d along = (far - near).normalized();
    const Eigen::Vector3d palmar = flexion.cross(along);
    const double near_radius = scale * kRadii[digit][i], far_radius = scale * kRadii[digit][i + 1];
    const Eigen::Vector3d end = i == 2 ? Eigen::Vector3d(far - far_radius * along) : far;
    const auto add = [&](const RoundedCone::Ends& ends) {
      digits_[digit].emplace_back(
          RoundedCone::Ends{bone * ends.a, bone * ends.b, ends.radius_a, ends.radius_b},
          bone.rotation * palmar, kDigitFlatness);
    };
    // The bone with the joints as its thickest places, and the pulp on its palmar side.
    const Eigen::Vector3d pulp = 2.2 * scale * palmar;
    add({near, end, near_radius, far_radius});
    add({near + 0.32 * (end - near) + pulp, near + (i == 2 ? 0.9 : 0.68) * (end - near) + pulp,
         0.9 * near_radius, (i == 2 ? 0.96 : 0.92) * far_radius});
  }
}

void HandSolid::add_thumb(const Skeleton& skeleton, const Transforms& transforms) {
  add_finger(skeleton, transforms, 0);
  constexpr double scale = kMillimetre;
  const Rigid3d& metacarpal = transforms[1];
  const Eigen::Vector3d& near = skeleton.keypoints[1];
  const Eigen::Vector3d way = skeleton.keypoints[2] - near;
  const Eigen::Vector3d flexion = skeleton.axes[2];
  const Eigen::Vector3d palmar = flexion.cross(way.normalized());
  // The thumb's eminence.
  digits_[0].emplace_back(RoundedCone::Ends{metacarpal * (near + 0.15 * way + 5.0 * scale * palmar),
                                            metacarpal * (near + 0.6 * way + 4.0 * scale * palmar),
                                            13.5 * scale, 13.0 * scale},
                          metacarpal.rotation * palmar, 1.0);
  // The web from the thumb to the index finger's metacarpal, a fan of folds.
  const Eigen::Vector3d index_base(-14.0 * scale, 40.0 * scale, -3.0 * scale);
  const Eigen::Vector3d index_way = 0.68 * (skeleton.keypoints[5] - index_base);
  for (const double part : {0.25, 0.5, 0.75, 1.0}) {
    palm_.emplace_back(RoundedCone::Ends{metacarpal * (near + (0.3 + 0.45 * part) * way),
                                         index_base + part * index_way, (10.5 - 3.0 * part) * scale,
                                         (10.5 - 3.0 * part) * scale},
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
