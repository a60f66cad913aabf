// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/penetration_term.h"

#include <algorithm>
#include <cmath>

namespace tegata {
namespace {

struct Segment {
  Eigen::Vector3d a, b;

  Eigen::Vector3d at(double fraction) const { return a + fraction * (b - a); }
  double nearest_fraction(const Eigen::Vector3d& point) const {
    const double squared = (b - a).squaredNorm();
    return squared > 0.0 ? std::clamp((point - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
  }
};

// Where two segments are nearest to each other.
struct Nearest {
  Eigen::Vector3d on_first, on_second;
};

// C. Ericson: Real-Time Collision Detection (2005), section 5.1.9.
Nearest nearest_points(const Segment& first, const Segment& second) {
  const Eigen::Vector3d u = first.b - first.a, v = second.b - second.a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const Eigen::Vector3d between = first.a - second.a;
  const double denominator = uu * vv - uv * uv;
  double s = 0.0;
  if (denominator > 1e-12 * uu * vv) {
    s = std::clamp((uv * v.dot(between) - vv * u.dot(between)) / denominator, 0.0, 1.0);
  }
  const Eigen::Vector3d on_second = second.at(second.nearest_fraction(first.at(s)));
  return {first.at(first.nearest_fraction(on_second)), on_second};
}

Segment rest_segment(const Skeleton& skeleton, int bone) {
  return {skeleton.keypoints[static_cast<std::size_t>(proximal_keypoint(bone))],
          skeleton.keypoints[static_cast<std::size_t>(distal_keypoint(bone))]};
}

// d (along . point of a bone) / d angles.
void add_row(const std::array<JointAxis, kAngleCount>& axes, int bone, const Eigen::Vector3d& point,
             const Eigen::Vector3d& along, HandRow& row) {
  const int digit = (bone - 1) / 3;
  for (int k = 0; k < kAnglesPerDigit; ++k) {
    const int angle = kAnglesPerDigit * digit + k;
    if (!angle_moves_bone(angle, bone)) continue;
    const JointAxis& axis = axes[static_cast<std::size_t>(angle)];
    row.values[kPoseParameterCount + angle] += along.dot(axis.direction.cross(point - axis.center));
  }
  row.digits |= DigitSet{1} << digit;
}

}  // namespace

DigitCapsules::DigitCapsules(const HandModel& hand) {
  const auto rest = bone_transforms(hand.skeleton, hand.rest_angles);
  std::array<std::vector<double>, kBoneCount> distances;
  for (std::size_t i = 0; i < hand.links.size(); ++i) {
    const int bone = main_bone(hand.links[i]);
    if (bone == 0) continue;
    Segment segment = rest_segment(hand.skeleton, bone);
    const Rigid3d& moved = rest[static_cast<std::size_t>(bone)];
    segment = {moved * segment.a, moved * segment.b};
    const Eigen::Vector3d& vertex = hand.rest_surface.vertices[i];
    distances[static_cast<std::size_t>(bone)].push_back(
        (segment.at(segment.nearest_fraction(vertex)) - vertex).norm());
  }
  for (std::size_t bone = 1; bone < radii_.size(); ++bone) {
    std::vector<double>& of_bone = distances[bone];
    if (of_bone.empty()) continue;
    const auto middle = of_bone.begin() + static_cast<std::ptrdiff_t>(of_bone.size() / 2);
    std::nth_element(of_bone.begin(), middle, of_bone.end());
    radii_[bone] = *middle;
  }
}

void add_penetration_term(const Skeleton& skeleton, const DigitCapsules& capsules,
                          const JointAngles& angles, const PenetrationTermOptions& options,
                          double scale, double weight, FrameEquations& equations) {
  const auto transforms = bone_transforms(skeleton, angles);
  const auto axes = joint_axes(skeleton, angles);
  std::array<Segment, kBoneCount> segments;
  for (int bone = 1; bone < kBoneCount; ++bone) {
    const Segment rest = rest_segment(skeleton, bone);
    const Rigid3d& moved = transforms[static_cast<std::size_t>(bone)];
    segments[static_cast<std::size_t>(bone)] = {moved * rest.a, moved * rest.b};
  }
  const double deviation = options.standard_deviation * scale;
  const double precision = weight / (deviation * deviation);
  for (int first = 1; first < kBoneCount; ++first) {
    const int next_digit = 1 + 3 * ((first - 1) / 3 + 1);
    for (int second = next_digit; second < kBoneCount; ++second) {
      const double allowed =
          (1.0 - options.free_share) * (capsules.radius(first) + capsules.radius(second));
      const auto [on_first, on_second] = nearest_points(segments[static_cast<std::size_t>(first)],
                                                        segments[static_cast<std::size_t>(second)]);
      const double distance = (on_first - on_second).norm();
      if (!(distance < allowed) || distance == 0.0) continue;
      const Eigen::Vector3d along = (on_first - on_second) / distance;
      HandRow row;
      add_row(axes, first, on_first, -along, row);
      add_row(axes, second, on_second, along, row);
      const double depth = allowed - distance;
      equations.add(depth, row, precision, 0.5 * precision * depth * depth);
    }
  }
}

}  // namespace tegata
