// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "tegata/fit/surface_fit.h"
#include "tegata/mesh/closest_point.h"

namespace tegata {

/// A point of a surface by its triangle and place in it.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  Eigen::Vector3d corners = Eigen::Vector3d::Zero();  ///< weights, sum 1
};

Eigen::Vector3d place_on(const TriangleMesh& mesh, const SurfacePoint& point);
/// The weights of a triangle's corners at a point of it; at a triangle without area the first
/// corner's alone.
SurfacePoint point_of_triangle(const TriangleMesh& mesh, std::uint32_t triangle,
                               const Eigen::Vector3d& point);
/// Unit, outwards; zero where the triangle has no area.
Eigen::Vector3d triangle_normal(const TriangleMesh& mesh, std::uint32_t triangle);
/// About 4000 points spread evenly by area over the whole of a surface, the same every time. Throws
/// Error for a surface without area.
std::vector<SurfacePoint> evenly_sampled(const TriangleMesh& mesh);

/// A hand's surface made ready for fit_surface(). Keeps a reference to what is given, which must
/// outlive it. Throws Error where fit_surface() does.
class SurfaceFitTarget {
 public:
  explicit SurfaceFitTarget(const HandSurface& given);

  const std::array<Eigen::Vector3d, kKeypointCount>& keypoints() const { return given_->keypoints; }
  const TriangleMesh& surface() const { return given_->surface; }
  const NearestSurface& nearest() const { return nearest_; }
  /// Samples beyond the wrist, with normals.
  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const std::vector<Eigen::Vector3d>& normals() const { return normals_; }
  /// On the side of the middle finger's MCP joint, of the plane through the wrist across the way
  /// there.
  bool is_beyond_wrist(const Eigen::Vector3d& point) const {
    return wrist_.signedDistance(point) > 0.0;
  }

 private:
  const HandSurface* given_;
  NearestSurface nearest_;
  Eigen::Hyperplane<double, 3> wrist_;
  std::vector<Eigen::Vector3d> points_, normals_;
};

/// Writes distances and keypoint errors of a fit whose shape, pose and model are known.
void measure_fit(const SurfaceFitTarget& target, SurfaceFit& fit);

}  // namespace tegata
