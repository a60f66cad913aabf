// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/tangency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tegata {
namespace {

constexpr double kPi = std::numbers::pi;

// Two cameras and the pencil of planes through both centres.
struct Pencil {
  Eigen::Vector3d along, up, side;  // world, orthonormal
};

Pencil pencil_of(const Camera& a, const Camera& b) {
  Pencil pencil;
  pencil.along = (b.center_in_world() - a.center_in_world()).normalized();
  pencil.up = pencil.along.unitOrthogonal();
  pencil.side = pencil.along.cross(pencil.up);
  return pencil;
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * kPi); }

// The planes that touch one view's silhouette on either side.
struct Tangents {
  bool usable = false;
  std::array<double, 2> angle = {0.0, 0.0};     // of the plane, from the reference
  std::array<double, 2> leverage = {0.0, 0.0};  // sine of the ray's angle to the baseline
  std::array<bool, 2> cut = {false, false};
};

Eigen::Vector3d middle_ray(const Camera& camera, const OutlineRays& outline) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& ray : outline.rays) sum += ray;
  return camera.camera_from_world.rotation.conjugate() * sum.normalized();
}

double plane_angle(const Pencil& pencil, const Eigen::Vector3d& direction) {
  return std::atan2(direction.dot(pencil.side), direction.dot(pencil.up));
}

// What goes on beyond the picture's edge may well reach past a tangent that is this near to where
// it is cut, as a share of the silhouette's width in the pencil.
constexpr double kReach = 0.2;

Tangents tangents_of(const Camera& camera, const OutlineRays& outline, const Pencil& pencil) {
  constexpr double kWidest = 120.0 / 180.0 * kPi;  // beyond it the epipole is too near
  constexpr double kLeastLeverage = 0.1;
  const Eigen::Quaterniond world_from_camera = camera.camera_from_world.rotation.conjugate();
  // Relative to the view's own middle, so that nothing wraps around.
  const double middle = plane_angle(pencil, middle_ray(camera, outline));
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double low_cut = low, high_cut = high;
  Tangents tangents;
  for (std::size_t i = 0; i < outline.rays.size(); ++i) {
    const Eigen::Vector3d direction = world_from_camera * outline.rays[i];
    const double angle = wrapped(plane_angle(pencil, direction) - middle);
    const double leverage = direction.cross(pencil.along).norm();
    if (leverage < kLeastLeverage) return {};
    const auto take = [&](std::size_t end) {
      tangents.angle[end] = middle + angle;
      tangents.leverage[end] = leverage;
    };
    if (outline.cut[i]) {
      low_cut = std::min(low_cut, angle);
      high_cut = std::max(high_cut, angle);
    }
    if (angle < low) {
      low = angle;
      take(0);
    }
    if (angle > high) {
      high = angle;
      take(1);
    }
  }
  const double reach = kReach * (high - low);
  tangents.cut = {low_cut - low <= reach, high - high_cut <= reach};
  tangents.usable = high - low < kWidest;
  return tangents;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

void append_angles(const Camera& a, const Camera& b, const OutlineRays& in_a,
                   const OutlineRays& in_b, std::vector<double>& angles) {
  const Pencil pencil = pencil_of(a, b);
  const Tangents first = tangents_of(a, in_a, pencil), second = tangents_of(b, in_b, pencil);
  if (!first.usable || !second.usable) return;
  const double parting = angle_between(middle_ray(a, in_a), pencil.along) -
                         angle_between(middle_ray(b, in_b), pencil.along);
  for (std::size_t end = 0; end < 2; ++end) {
    if (first.cut[end] || second.cut[end]) continue;
    const double planes = std::abs(wrapped(first.angle[end] - second.angle[end]));
    angles.push_back(planes * std::min(first.leverage[end], second.leverage[end]) +
                     std::max(parting, 0.0));
  }
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<PairTangency> pair_tangencies(const CameraRig& rig, const RigOutlines& frames) {
  constexpr double kSamePlace = 1e-9;
  std::vector<PairTangency> pairs;
  for (std::size_t a = 0; a < rig.size(); ++a) {
    for (std::size_t b = a + 1; b < rig.size(); ++b) {
      if ((rig[a].center_in_world() - rig[b].center_in_world()).norm() < kSamePlace) continue;
      std::vector<double> angles;
      for (const auto& frame : frames) {
        if (frame[a] && frame[b]) append_angles(rig[a], rig[b], *frame[a], *frame[b], angles);
      }
      if (angles.empty()) continue;
      pairs.push_back({a, b, angles.size(), median_of(angles)});
    }
  }
  return pairs;
}

double tangency_cost(const std::vector<PairTangency>& pairs) {
  constexpr double kMost = 30.0 / 180.0 * kPi;
  double sum = 0.0;
  for (const PairTangency& pair : pairs) sum += std::min(pair.median, kMost);
  return pairs.empty() ? 0.0 : sum / static_cast<double>(pairs.size());
}

}  // namespace tegata
