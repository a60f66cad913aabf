// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/hull/octree.h"
#include "tegata/image/silhouette.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// One undistorted camera and what it saw.
struct HullView {
  Camera camera;
  Silhouette silhouette;
};

struct HullOptions {
  double voxel_size = 0.002;  ///< of the finest cells [m]
  /// A point survives so many views that see background there; fewer than must see it, at most 15.
  int dissenting_views = 0;
  /// A point that fewer views see is outside. 0: more than half of the views suffice, or two (a
  /// quarter, if that is more) of which two look across each other, from 45 to 135 degrees apart:
  /// the space between cameras that face each other fills with what only they see.
  int least_views = 0;
  std::size_t triangle_count = 4000;  ///< after simplification; 0: as it comes
  /// Simplification stops here even if more triangles are left [m]; see simplify().
  double largest_error = std::numeric_limits<double>::infinity();
  double smallest_component = 0.05;  ///< pieces with a smaller share of the largest are dropped
};

struct HullReport {
  Eigen::AlignedBox3d region;  ///< that the silhouettes allow [m]
  std::vector<SparseField::Level> levels;
  std::size_t raw_triangle_count = 0;
  std::size_t triangle_count = 0;
  double volume = 0.0;              ///< [m^3]
  double region_seconds = 0.0;      ///< of the tables and of finding the region
  double carve_seconds = 0.0;       ///< of the distances and of the octree
  double isosurface_seconds = 0.0;  ///< of the components and of marching cubes
  double simplify_seconds = 0.0;
};

/// The box, of those that may hold the object, found by volume intersection on a coarse lattice
/// that is refined where anything survives. Throws Error, naming the view without which something
/// would survive, where the silhouettes have no point in common.
Eigen::AlignedBox3d find_region(const std::vector<HullView>& views, const HullOptions& options);

/// Volume intersection on an octree (Potmesil 1987; the paper, III-A): nodes are kept, split or
/// dropped by conservative tests of their projected boxes against summed-area tables; the corners
/// of the finest cells carry how far inside the nearest silhouette edge they lie, in metres at
/// their depth. Unknown pixels carve nothing; a view that does not see a point says nothing about
/// it. Leaves that only unknown pixels or the pictures' edges made are marked as unproven.
SparseField carve(const std::vector<HullView>& views, const Eigen::AlignedBox3d& region,
                  const HullOptions& options);

/// Region, volume intersection, isosurface, components and simplification in one call.
TriangleMesh visual_hull(const std::vector<HullView>& views, const HullOptions& options,
                         HullReport* report = nullptr);

}  // namespace tegata
