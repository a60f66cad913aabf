// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// The nearest of a fixed set of points, by a uniform grid of cells sorted by counting.
class NearestPoint {
 public:
  /// Points in metres; at least one, all finite. Throws Error otherwise.
  explicit NearestPoint(std::vector<Eigen::Vector3d> points);

  struct Match {
    std::uint32_t index = 0;
    double distance = 0.0;  ///< [m]
  };
  /// The nearest point; of equally near ones the lowest index.
  Match nearest(const Eigen::Vector3d& query) const;
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  struct Search;
  struct Numbered {
    Eigen::Vector3d point;
    std::uint32_t index;
  };
  void choose_cells();
  void search_run(std::size_t first_cell, std::size_t last_cell, Search& search) const;
  void search_shell(int radius, Search& search) const;
  double distance2_to_cell(double query, int axis, int cell) const;
  std::size_t first_of_row(int y, int z) const {
    return static_cast<std::size_t>(z * cells_per_axis_.y() + y) *
           static_cast<std::size_t>(cells_per_axis_.x());
  }

  std::vector<Eigen::Vector3d> points_;
  Eigen::Vector3d origin_;
  double cell_size_ = 0.0, cells_per_metre_ = 0.0;
  Eigen::Array3i cells_per_axis_;
  std::vector<std::uint32_t> cell_start_;  ///< where each cell's run begins in sorted_
  std::vector<Numbered> sorted_;           ///< points by cell
};

/// The nearest point on a fixed set of triangles, by a tree of boxes.
class NearestSurface {
 public:
  /// The mesh is copied; at least one triangle. Throws Error otherwise.
  explicit NearestSurface(const TriangleMesh& mesh);

  struct Match {
    Eigen::Vector3d point;
    std::uint32_t triangle = 0;
    double distance = 0.0;  ///< [m]
  };
  /// The nearest point; of triangles that are equally near to rounding, always the same one.
  Match nearest(const Eigen::Vector3d& query) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t first = 0, count = 0;  ///< leaf: run of triangles; inner: count 0, first child
  };
  void split(std::uint32_t node, std::vector<Eigen::Vector3d>& centers);

  TriangleMesh mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// The point of a triangle nearest to a query; of a triangle without area the nearest point of its
/// sides.
Eigen::Vector3d closest_point_on_triangle(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                                          const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace tegata
