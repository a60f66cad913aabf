// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_fit_target.h"

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr std::size_t kSamples = 4000;  // of a surface

Eigen::Vector3d cross_of_sides(const TriangleMesh& mesh, std::uint32_t triangle) {
  const Triangle& corner = mesh.triangles[triangle];
  const Eigen::Vector3d& a = mesh.vertices[corner[0]];
  return (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
}

/// The fractional part of a multiple of an irrational number: evenly spread over 0 to 1.
double spread(std::size_t i, double step) {
  const double x = step * static_cast<double>(i + 1);
  return x - std::floor(x);
}

}  // namespace

Eigen::Vector3d place_on(const TriangleMesh& mesh, const SurfacePoint& point) {
  const Triangle& triangle = mesh.triangles[point.triangle];
  return point.corners[0] * mesh.vertices[triangle[0]] +
         point.corners[1] * mesh.vertices[triangle[1]] +
         point.corners[2] * mesh.vertices[triangle[2]];
}

SurfacePoint point_of_triangle(const TriangleMesh& mesh, std::uint32_t triangle,
                               const Eigen::Vector3d& point) {
  const Triangle& corner = mesh.triangles[triangle];
  const Eigen::Vector3d& a = mesh.vertices[corner[0]];
  const Eigen::Vector3d u = mesh.vertices[corner[1]] - a, v = mesh.vertices[corner[2]] - a;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double pu = u.dot(point - a), pv = v.dot(point - a);
  const double scale = uu * vv - uv * uv;
  if (!(scale > 0.0)) return {triangle, {1.0, 0.0, 0.0}};
  const double second = (vv * pu - uv * pv) / scale, third = (uu * pv - uv * pu) / scale;
  return {triangle, {1.0 - second - third, second, third}};
}

Eigen::Vector3d triangle_normal(const TriangleMesh& mesh, std::uint32_t triangle) {
  return cross_of_sides(mesh, triangle).normalized();
}

std::vector<SurfacePoint> evenly_sampled(const TriangleMesh& mesh) {
  std::vector<SurfacePoint> points;
  points.reserve(kSamples);
  const double area_each = surface_area(mesh) / static_cast<double>(kSamples);
  if (!(area_each > 0.0)) throw Error("surface fit: the surface has no area");
  double due = 0.5;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    due += 0.5 * cross_of_sides(mesh, t).norm() / area_each;
    for (; due >= 1.0; due -= 1.0) {
      // Roberts' plastic-number sequence, folded into the triangle.
      double a = spread(points.size(), 0.7548776662466927);
      double b = spread(points.size(), 0.5698402909980532);
      if (a + b > 1.0) {
        a = 1.0 - a;
        b = 1.0 - b;
      }
      points.push_back({t, {1.0 - a - b, a, b}});
    }
  }
  return points;
}

SurfaceFitTarget::SurfaceFitTarget(const HandSurface& given)
    : given_(&given), nearest_(given.surface) {
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    if (!given.keypoints[k].allFinite()) {
      throw Error("surface fit: keypoint ", keypoint_names()[k], " is not finite");
    }
  }
  const Eigen::Vector3d way = given.keypoints[9] - given.keypoints[0];
  if (!(way.norm() > 0.0)) throw Error("surface fit: wrist and middle_mcp are at one place");
  wrist_ = Eigen::Hyperplane<double, 3>(way.normalized(), given.keypoints[0]);
  for (const SurfacePoint& sample : evenly_sampled(given.surface)) {
    const Eigen::Vector3d point = place_on(given.surface, sample);
    if (!is_beyond_wrist(point)) continue;
    points_.push_back(point);
    normals_.push_back(triangle_normal(given.surface, sample.triangle));
  }
  if (points_.empty()) throw Error("surface fit: nothing of the surface lies beyond the wrist");
}

void measure_fit(const SurfaceFitTarget& target, SurfaceFit& fit) {
  const PosedHand posed(fit.model, fit.pose);
  const TriangleMesh surface = posed.surface();
  const NearestSurface nearest(surface);
  std::vector<double> distances;
  double to_hand = 0.0;
  for (const Eigen::Vector3d& point : target.points()) {
    distances.push_back(nearest.nearest(point).distance);
    to_hand += distances.back();
  }
  const double from_target = static_cast<double>(distances.size());
  double to_target = 0.0;
  for (const SurfacePoint& sample : evenly_sampled(surface)) {
    const Eigen::Vector3d point = place_on(surface, sample);
    if (!target.is_beyond_wrist(point)) continue;
    distances.push_back(target.nearest().nearest(point).distance);
    to_target += distances.back();
  }
  const double from_hand = static_cast<double>(distances.size()) - from_target;
  fit.mean_distance = 0.5 * (to_hand / from_target + to_target / std::max(from_hand, 1.0));
  const auto place_95 = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 19 / 20);
  std::nth_element(distances.begin(), place_95, distances.end());
  fit.distance_95 = *place_95;
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    fit.keypoint_errors[k] = (posed.keypoints()[k] - target.keypoints()[k]).norm();
    if (k % 4 != 0) fit.mean_joint_error += fit.keypoint_errors[k] / (3.0 * kDigitCount);
  }
}

}  // namespace tegata
