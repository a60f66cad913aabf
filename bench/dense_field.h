// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tegata/hull/visual_hull.h"
#include "tegata/image/image.h"

namespace tegata::bench {

/// The hull's field by its definition alone, for a loop over every point of the lattice: distances
/// over whole pictures, every view asked, no tables. Without dissenting views.
class DenseField {
 public:
  DenseField(const std::vector<HullView>& views, const HullOptions& options);

  float value(const Eigen::Vector3d& point) const;  ///< [m], positive inside
  bool is_inside(const Eigen::Vector3d& point) const;

 private:
  struct View {
    Eigen::Matrix3d pixel_from_world;
    Eigen::Vector3d pixel_offset;
    double width, height, metres_per_pixel;
    Image<float> distance;
  };
  // Calls visit(view, depth, x, y) for the views that see a point, until it returns false.
  template <typename Visit>
  std::size_t for_each_seeing(const Eigen::Vector3d& point, const Visit& visit) const;

  std::vector<View> views_;
  std::size_t least_views_;
};

/// A lattice of points: cells + 1 a side.
struct Lattice {
  Eigen::Vector3d origin;
  double cell_size = 0.0;  ///< [m]
  std::int32_t cells = 0;

  std::int32_t points() const { return cells + 1; }
  std::size_t point_count() const;
  std::size_t index(std::int32_t x, std::int32_t y, std::int32_t z) const;
  Eigen::Vector3d at(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return origin + cell_size * Eigen::Vector3d(x, y, z);
  }
};

/// The lattice of an octree's root cube.
Lattice lattice_of(const SparseField& field);

/// How many points of the lattice, its faces left out, are inside by the dense field and outside by
/// the leaves or the other way round. Between leaves a row is taken to stay what it was.
std::size_t count_differing_points(const SparseField& field, const DenseField& dense);

/// The value at every point, x fastest; that of the leaves where a leaf has a corner there, and
/// far outside on the other points of the cube's faces.
std::vector<float> dense_values(const SparseField& field, const DenseField& dense);

}  // namespace tegata::bench
