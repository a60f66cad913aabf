// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/evaluate/surface_error.h"

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/mesh/closest_point.h"

namespace tegata {
namespace {

constexpr std::size_t kSampleCount = 5000;
// Many more are drawn at most, for a surface most of which lies behind the plane.
constexpr std::size_t kMostDrawn = 32 * kSampleCount;
constexpr std::uint64_t kSeed = 1;

using Plane = Eigen::Hyperplane<double, 3>;

std::vector<Eigen::Vector3d> in_front(const std::vector<Eigen::Vector3d>& points,
                                      const Plane& plane) {
  std::vector<Eigen::Vector3d> kept;
  for (const Eigen::Vector3d& point : points) {
    if (plane.signedDistance(point) >= 0.0) kept.push_back(point);
  }
  return kept;
}

// About kSampleCount points in front of the plane.
std::vector<Eigen::Vector3d> sample_in_front(const TriangleMesh& mesh, const Plane& plane) {
  const std::vector<Eigen::Vector3d> kept = in_front(sample_surface(mesh, kSampleCount), plane);
  if (kept.empty() || kept.size() == kSampleCount) return kept;
  const std::size_t count = std::min(kMostDrawn, kSampleCount * kSampleCount / kept.size());
  return in_front(sample_surface(mesh, count), plane);
}

double mean_distance(const std::vector<Eigen::Vector3d>& points, const NearestSurface& surface) {
  double sum = 0.0;
  for (const Eigen::Vector3d& point : points) sum += surface.nearest(point).distance;
  return sum / static_cast<double>(points.size());
}

}  // namespace

std::vector<Eigen::Vector3d> sample_surface(const TriangleMesh& mesh, std::size_t count) {
  std::vector<double> area_up_to;
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    area += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    area_up_to.push_back(area);
  }
  if (!(area > 0.0)) throw Error("got a surface without an area, expected triangles");
  Random random(kSeed);
  std::vector<Eigen::Vector3d> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // One point for each of `count` equal parts of the area: less noise than drawn freely.
    const double at =
        area * (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, at);
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(found - area_up_to.begin())];
    // Uniform in the triangle (Osada et al. 2002, 4.1).
    const double root = std::sqrt(random.uniform()), share = random.uniform();
    points.emplace_back((1.0 - root) * mesh.vertices[t[0]] +
                        root * (1.0 - share) * mesh.vertices[t[1]] +
                        root * share * mesh.vertices[t[2]]);
  }
  return points;
}

double surface_error(const TriangleMesh& fitted, const TriangleMesh& truth,
                     const Plane& wrist_plane) {
  std::vector<Eigen::Vector3d> on_fitted = sample_in_front(fitted, wrist_plane);
  if (on_fitted.empty()) on_fitted = sample_surface(fitted, kSampleCount);
  const std::vector<Eigen::Vector3d> on_truth = sample_in_front(truth, wrist_plane);
  if (on_truth.empty()) {
    throw Error("the true surface has nothing on the finger side of the true wrist, expected the ",
                "surface and the keypoints in one frame and in metres");
  }
  return 0.5 * (mean_distance(on_fitted, NearestSurface(truth)) +
                mean_distance(on_truth, NearestSurface(fitted)));
}

std::optional<double> held_object_error(const TriangleMesh& found, const TriangleMesh& truth,
                                        const TriangleMesh& hand, double reach) {
  const NearestSurface hand_surface(hand);
  std::vector<Eigen::Vector3d> held = sample_surface(truth, kSampleCount);
  std::erase_if(held, [&](const Eigen::Vector3d& point) {
    return hand_surface.nearest(point).distance > reach;
  });
  if (held.empty()) return std::nullopt;
  return mean_distance(held, NearestSurface(found));
}

std::optional<double> vertex_error(const TriangleMesh& fitted, const TriangleMesh& truth) {
  if (fitted.vertices.size() != truth.vertices.size() || fitted.triangles != truth.triangles ||
      truth.vertices.empty()) {
    return std::nullopt;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.vertices.size(); ++i) {
    sum += (fitted.vertices[i] - truth.vertices[i]).norm();
  }
  return sum / static_cast<double>(truth.vertices.size());
}

}  // namespace tegata
