// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/octree.h"

#include <cmath>

#include "tegata/base/error.h"
#include "tegata/hull/lattice_map.h"
#include "tegata/hull/octree_division.h"

namespace tegata {
namespace {

constexpr int kMostDepth = 20;

// FieldSource as OctreeDivision asks for it. Each lattice point is sampled once.
class CalledSource {
 public:
  struct State {};
  static constexpr int kBlockCells = 2;

  CalledSource(const FieldSource& source, const OctreeRoot& root)
      : source_(source), root_(root), points_(Point{}) {}

  Occupancy classify(const Eigen::Vector3d& center, double half_side, State&) const {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(half_side);
    return source_.classify(Eigen::AlignedBox3d(center - reach, center + reach));
  }

  void sample(const LatticeIndex& low, const State&, BlockValues<kBlockCells>& block) {
    for (std::size_t i = 0; i < BlockValues<kBlockCells>::kPoints; ++i) {
      const auto offset = static_cast<std::int32_t>(i);
      const LatticeIndex index = {low[0] + offset % 3, low[1] + offset / 3 % 3,
                                  low[2] + offset / 9};
      Point& point = points_[index];
      if (!point.known) {
        point.field = source_.sample(
            root_.origin + root_.cell_size * Eigen::Vector3d(index[0], index[1], index[2]),
            point.unproven);
        point.unproven = point.unproven && point.field > 0.0f;
        point.known = true;
      }
      block.field[i] = point.field;
      block.unproven[i] = point.unproven ? 1 : 0;
    }
  }

 private:
  struct Point {
    float field = 0.0f;
    bool known = false, unproven = false;
  };

  const FieldSource& source_;
  OctreeRoot root_;
  LatticeMap<Point> points_;
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
  OctreeRoot root{.origin = region.center(), .cell_size = cell_size};
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
  const OctreeRoot root = root_around(region, cell_size);
  CalledSource called(source, root);
  return OctreeDivision<CalledSource>(root, called).run();
}

}  // namespace tegata
