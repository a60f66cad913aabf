// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "tegata/hull/visual_hull.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata::bench {

/// What the benchmarks work on: ideal cameras of 640 x 480 pixels in the virtual room and what they
/// see, nothing before it.
struct Scene {
  TriangleMesh surface;  ///< of what the cameras see, in world coordinates
  std::vector<HullView> views;

  Eigen::Vector3d center() const { return bounding_box(surface).center(); }
  std::size_t mean_foreground() const;  ///< hand pixels a view
};

/// A hand grasping a cylinder that is not there.
Scene hand_scene(int camera_count);

/// A ball of 400 mm diameter, seen with shorter lenses.
Scene ball_scene(int camera_count);

/// A region that makes carve() divide a cube of just so many cells a side (a power of two) around
/// `center`.
Eigen::AlignedBox3d region_of_cells(const Eigen::Vector3d& center, int cells, double cell_size);

/// The options of a hull of so many views, all others as they come.
HullOptions hull_options(const Scene& scene, double voxel_size);

}  // namespace tegata::bench
