// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/octree.h"

#include <cmath>

#include "tegata/base/error.h"
#include "tegata/hull/octree_division.h"

namespace tegata {
namespace {

constexpr int kMostDepth = 20;

// FieldSource as OctreeDivision asks for it.
class CalledSource {
 public:
  struct State {};

  explicit CalledSource(const FieldSource& source) : source_(source) {}
  Occupancy classify(const Eigen::Vector3d& center, double half_side, State&) const {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(half_side);
    return source_.classify(Eigen::AlignedBox3d(center - reach, center + reach));
  }
  float sample(const Eigen::Vector3d& point, bool& unproven) const {
    return source_.sample(point, unproven);
  }

 private:
  const FieldSource& source_;
};

}  // namespace

OctreeRoot root_around(const Eigen::AlignedBox3d& region, double cell_size) {
  if (!(cell_size > 0.0) || !std::isfinite(cell_size)) {
    throw Error("octree: got cells of ", cell_size, " m, expected a positive size");
  }
  if (region.isEmpty() || !region.min().allFinite() || !region.max().allFinite()) {
    throw Error("octree: got a region from (", region.min().transpose(), ") to (",
                region.max().transpose(), ") m, expected a finite box that is not empty");
  }
  const double cells_needed = region.sizes().maxCoeff() / cell_size + 2.0;
  OctreeRoot root{.origin = region.center(), .cell_size = cell_size, .depth = 1};
  while (root.depth < kMostDepth && root.cells() < cells_needed) ++root.depth;
  if (root.cells() < cells_needed) {
    throw Error("octree: got cells of ", cell_size, " m for a region of ",
                region.sizes().maxCoeff(), " m, expected at most 2^", kMostDepth,
                " cells a side; larger cells would do");
  }
  root.origin -= Eigen::Vector3d::Constant(0.5 * root.cells() * cell_size);
  return root;
}

SparseField build_octree(const Eigen::AlignedBox3d& region, double cell_size,
                         const FieldSource& source) {
  const CalledSource called(source);
  return OctreeDivision<CalledSource>(root_around(region, cell_size), called).run();
}

}  // namespace tegata
