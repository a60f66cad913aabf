// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/forearm.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tegata {
namespace {

// Of a hand of scale 1 [m]: the forearm begins so far behind the wrist and is looked at so far.
constexpr double kBegin = 0.015, kEnd = 0.35;
// So far behind the wrist it is sought first, and nothing of it is farther from its axis: the mean
// radius of a strong man's is 0.053 (circumference 33 cm, Gordon et al. 1988), corners of its hull
// by two cameras are half as far again. Where pictures end, hulls have pieces in empty space.
constexpr double kNear = 0.12, kWidest = 0.08;
constexpr double kRingDistance = 0.03;
constexpr double kMargin = 0.004;  // by which the body is wider than what was seen
constexpr double kBeyond = 0.3;    // so far the arm goes on behind the hull's end
constexpr std::size_t kLeastPoints = 20;
constexpr std::uint32_t kSectors = 16;
// Of the points about a ring so many lie inside; the hull's corners do not.
constexpr double kInside = 0.8;

struct AxisPoint {
  double along = 0.0, radius = 0.0;
};

std::vector<AxisPoint> rings_of(const std::vector<AxisPoint>& points, double scale) {
  double last = 0.0;
  for (const AxisPoint& point : points) last = std::max(last, point.along);
  std::vector<AxisPoint> rings;
  for (double along = kBegin * scale; along < last + kRingDistance * scale;
       along += kRingDistance * scale) {
    std::vector<double> radii;
    for (const AxisPoint& point : points) {
      if (std::abs(point.along - along) < kRingDistance * scale) radii.push_back(point.radius);
    }
    if (radii.empty()) {
      if (!rings.empty()) rings.push_back({along, rings.back().radius});
      continue;
    }
    const auto place = radii.begin() +
                       static_cast<std::ptrdiff_t>(kInside * static_cast<double>(radii.size() - 1));
    std::nth_element(radii.begin(), place, radii.end());
    rings.push_back({along, *place + kMargin * scale});
  }
  return rings;
}

double from_axis(const Eigen::Vector3d& point, const Eigen::Vector3d& axis) {
  return (point - axis.dot(point) * axis).norm();
}

// The points, in the hand's frame, that can be the forearm's, and the axis through the wrist that
// they lie about.
struct HullPart {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();

  template <typename Belongs>
  HullPart among(const Belongs& belongs) const {
    HullPart found;
    for (const Eigen::Vector3d& point : points) {
      if (!belongs(point)) continue;
      found.points.push_back(point);
      found.axis += point;
    }
    found.axis.normalize();
    return found;
  }
  bool is_seen() const { return points.size() >= kLeastPoints; }
};

// About the axis of what is near the wrist, then about that of what is found so.
HullPart about_its_axis(const HullPart& behind, double scale) {
  HullPart found =
      behind.among([scale](const Eigen::Vector3d& point) { return point.norm() < kNear * scale; });
  if (!found.is_seen()) found = behind;
  for (int round = 0; round < 2 && found.is_seen(); ++round) {
    const Eigen::Vector3d axis = found.axis;
    found = behind.among([&axis, scale](const Eigen::Vector3d& point) {
      return from_axis(point, axis) < kWidest * scale;
    });
  }
  return found;
}

bool is_shown_by_all(const std::vector<FitView>& views, const Eigen::Vector3d& point) {
  return std::all_of(views.begin(), views.end(), [&](const FitView& view) {
    const auto pixel = project(view.camera, point);
    return pixel && view.camera.contains(*pixel);
  });
}

TriangleMesh body(const std::vector<AxisPoint>& rings, const Eigen::Vector3d& axis) {
  TriangleMesh mesh;
  const Eigen::Vector3d across = axis.unitOrthogonal(), third = axis.cross(across);
  for (const AxisPoint& ring : rings) {
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kSectors;
      mesh.vertices.push_back(ring.along * axis +
                              ring.radius * (std::cos(turn) * across + std::sin(turn) * third));
    }
  }
  const auto count = static_cast<std::uint32_t>(rings.size());
  for (std::uint32_t r = 0; r + 1 < count; ++r) {
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const std::uint32_t a = r * kSectors + i, b = r * kSectors + (i + 1) % kSectors;
      mesh.triangles.push_back({a, b, a + kSectors});
      mesh.triangles.push_back({b, b + kSectors, a + kSectors});
    }
  }
  for (const std::uint32_t first : {0U, (count - 1) * kSectors}) {
    for (std::uint32_t i = 1; i + 1 < kSectors; ++i) {
      mesh.triangles.push_back({first, first + i, first + i + 1});
    }
  }
  return mesh;
}

}  // namespace

std::optional<Forearm> find_forearm(const FitHand& hand, const FitFrame& frame,
                                    const Rigid3d& world_from_hand) {
  if (!frame.hull) return std::nullopt;
  const Rigid3d hand_from_world = world_from_hand.inverse();
  HullPart hull;
  for (const Eigen::Vector3d& point : frame.hull->nearest.points()) {
    hull.points.push_back(hand_from_world * point);
  }
  const HullPart behind = hull.among([&hand](const Eigen::Vector3d& point) {
    return point.y() < -kBegin * hand.scale && point.norm() < kEnd * hand.scale;
  });
  if (!behind.is_seen()) return std::nullopt;
  // What some picture does not show is bounded by fewer of them, and so wider than the arm.
  const HullPart shown = behind.among([&](const Eigen::Vector3d& point) {
    return is_shown_by_all(frame.views, world_from_hand * point);
  });
  const HullPart forearm = about_its_axis(shown.is_seen() ? shown : behind, hand.scale);
  if (!forearm.is_seen()) return std::nullopt;
  const Eigen::Vector3d& axis = forearm.axis;
  const HullPart all = behind.among(
      [&](const Eigen::Vector3d& point) { return from_axis(point, axis) < kWidest * hand.scale; });
  std::vector<AxisPoint> points;
  for (const Eigen::Vector3d& point : all.points) {
    points.push_back({axis.dot(point), from_axis(point, axis)});
  }
  const std::vector<AxisPoint> rings = rings_of(points, hand.scale);
  if (rings.size() < 2) return std::nullopt;
  const AxisPoint end = rings.back();
  const std::vector<AxisPoint> beyond = {end,
                                         {end.along + kWidest * hand.scale, kWidest * hand.scale},
                                         {end.along + kBeyond * hand.scale, kWidest * hand.scale}};
  Forearm found{body(rings, axis), body(beyond, axis)};
  for (TriangleMesh* mesh : {&found.surface, &found.beyond}) {
    for (Eigen::Vector3d& vertex : mesh->vertices) vertex = world_from_hand * vertex;
  }
  return found;
}

}  // namespace tegata
