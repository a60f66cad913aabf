// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "tegata/hull/lattice_map.h"
#include "tegata/hull/octree.h"

namespace tegata {

/// The root cube of an octree: 2^depth cells a side, the first corner at `origin`.
struct OctreeRoot {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double cell_size = 0.0;  ///< [m]
  int depth = 1;           ///< at least 1

  std::int32_t cells() const { return std::int32_t{1} << depth; }
};

/// The root cube that build_octree() divides: centred on the region. Throws Error as it does.
OctreeRoot root_around(const Eigen::AlignedBox3d& region, double cell_size);

/// FieldSource for compilers: State is what a cube hands down to its eighths (copied to each), such
/// as what needs not be asked again.
template <typename Source>
concept OctreeSource = requires(const Source& source, typename Source::State& state,
                                const Eigen::Vector3d& point, double half_side, bool& unproven) {
  { source.classify(point, half_side, state) } -> std::same_as<Occupancy>;
  { source.sample(point, unproven) } -> std::convertible_to<float>;
};

/// Divides a cube depth first. Cubes of two cells a side that stay mixed are sampled at their 27
/// lattice points, each point of the lattice once; their eight cells are judged by signs alone.
template <OctreeSource Source>
class OctreeDivision {
 public:
  OctreeDivision(const OctreeRoot& root, const Source& source)
      : root_(root), source_(source), corners_(Corner{}) {}

  SparseField run() {
    field_.origin = root_.origin;
    field_.cell_size = root_.cell_size;
    field_.levels.resize(static_cast<std::size_t>(root_.depth) + 1);
    visit({0, 0, 0}, 0, typename Source::State{});
    return std::move(field_);
  }

 private:
  enum class Known : std::uint8_t { nothing, proven, unproven };
  struct Corner {
    float value = 0.0f;
    Known known = Known::nothing;
  };

  // Of the 27 points of a cube of two cells a side, those that are corners of its first cell.
  static constexpr std::uint32_t kCellCorners =
      1u | 1u << 1 | 1u << 3 | 1u << 4 | 1u << 9 | 1u << 10 | 1u << 12 | 1u << 13;

  void visit(const LatticeIndex& low, int level, typename Source::State state) {
    const std::int32_t side = root_.cells() >> level;
    const double half_side = 0.5 * side * root_.cell_size;
    SparseField::Level& counts = field_.levels[static_cast<std::size_t>(level)];
    ++counts.visited;
    const Occupancy occupancy =
        source_.classify(point_at(low) + Eigen::Vector3d::Constant(half_side), half_side, state);
    if (occupancy == Occupancy::outside) {
      ++counts.outside;
    } else if (occupancy == Occupancy::inside && !touches_root_face(low, side)) {
      ++counts.inside;
    } else if (side == 2) {
      sample_cells(low);
    } else {
      const std::int32_t half = side / 2;
      for (int i = 0; i < 8; ++i) {
        visit({low[0] + (i & 1) * half, low[1] + (i >> 1 & 1) * half, low[2] + (i >> 2) * half},
              level + 1, state);
      }
    }
  }

  void sample_cells(const LatticeIndex& low) {
    std::array<Corner, 27> corners;
    std::uint32_t inside = 0, unproven = 0;  // bit i: corner i
    for (std::int32_t i = 0; i < 27; ++i) {
      const Corner& corner = corner_at({low[0] + i % 3, low[1] + i / 3 % 3, low[2] + i / 9});
      corners[static_cast<std::size_t>(i)] = corner;
      inside |= (corner.value > 0.0f ? 1u : 0u) << i;
      unproven |= (corner.known == Known::unproven ? 1u : 0u) << i;
    }
    SparseField::Level& counts = field_.levels.back();
    counts.visited += 8;
    for (std::int32_t cell = 0; cell < 8; ++cell) {
      const std::int32_t x = cell & 1, y = cell >> 1 & 1, z = cell >> 2;
      const std::int32_t first = x + 3 * y + 9 * z;
      const std::uint32_t mask = kCellCorners << first;
      if ((inside & mask) == 0) {
        ++counts.outside;
        continue;
      }
      if ((inside & mask) == mask) {
        ++counts.inside;
        continue;
      }
      OctreeLeaf& leaf = field_.leaves.emplace_back();
      leaf.index = {low[0] + x, low[1] + y, low[2] + z};
      for (std::int32_t i = 0; i < 8; ++i) {
        leaf.field[static_cast<std::size_t>(i)] =
            corners[static_cast<std::size_t>(first + (i & 1) + 3 * (i >> 1 & 1) + 9 * (i >> 2))]
                .value;
      }
      leaf.unproven = (unproven & mask) != 0;
    }
  }

  const Corner& corner_at(const LatticeIndex& index) {
    Corner& corner = corners_[index];
    if (corner.known != Known::nothing) return corner;
    bool unproven = false;
    corner.value = source_.sample(point_at(index), unproven);
    if (corner.value > 0.0f && touches_root_face(index, 0)) {
      corner.value = -static_cast<float>(root_.cell_size);
    }
    corner.known = unproven && corner.value > 0.0f ? Known::unproven : Known::proven;
    return corner;
  }

  Eigen::Vector3d point_at(const LatticeIndex& index) const {
    return root_.origin + root_.cell_size * Eigen::Vector3d(index[0], index[1], index[2]);
  }

  // Whether a cube (a point, for side 0) reaches the faces on which everything is outside.
  bool touches_root_face(const LatticeIndex& low, std::int32_t side) const {
    for (const std::int32_t coordinate : low) {
      if (coordinate == 0 || coordinate + side == root_.cells()) return true;
    }
    return false;
  }

  OctreeRoot root_;
  const Source& source_;
  LatticeMap<Corner> corners_;
  SparseField field_;
};

}  // namespace tegata
