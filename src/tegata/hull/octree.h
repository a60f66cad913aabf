// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace tegata {

/// Indices of a point of the lattice: point_in_world = origin + cell_size * index.
using LatticeIndex = std::array<std::int32_t, 3>;

/// A finest cube of the octree that the surface may pass through.
struct OctreeLeaf {
  LatticeIndex index;          ///< its lowest corner
  std::array<float, 8> field;  ///< at its corners, x fastest, then y, then z; positive inside
  /// At some of its corners nothing proves what the field says: they are inside by unknown pixels
  /// only, or outside because too few views see them.
  bool unproven = false;
};

/// A field known only where it changes sign: the leaves of an octree. A corner is inside where the
/// field is above zero; zero itself is outside. Two leaves that share a corner have the same value
/// there, and every cell that the surface crosses is a leaf.
struct SparseField {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double cell_size = 0.0;  ///< [m]
  std::vector<OctreeLeaf> leaves;
  /// Cells by what became of them, one entry a level from the root: visited, kept whole as inside,
  /// dropped as outside.
  struct Level {
    std::size_t visited = 0, inside = 0, outside = 0;
  };
  std::vector<Level> levels;
};

/// What is certain of a cube before it is split.
enum class Occupancy : std::uint8_t { outside, inside, mixed };

/// The two questions an octree asks of what it divides. Both must agree: a cube called inside
/// (outside) has a positive (negative) field at each of its lattice corners.
struct FieldSource {
  /// Conservative: mixed where in doubt.
  std::function<Occupancy(const Eigen::AlignedBox3d& cube)> classify;
  /// The field at a lattice corner, positive inside; `unproven` is set where only unknown pixels
  /// say that the point is inside.
  std::function<float(const Eigen::Vector3d& point, bool& unproven)> sample;
};

/// Divides a cube around `region`, at least one cell wider on every side, down to cells of
/// `cell_size` (at most 2^20 cells a side). Corners on the cube's own faces count as outside, so
/// that the surface is always closed. Leaves come in the same order every time: block by block, x
/// fastest. Throws Error where the region is empty or not finite or the cells are too small for it.
SparseField build_octree(const Eigen::AlignedBox3d& region, double cell_size,
                         const FieldSource& source);

}  // namespace tegata
