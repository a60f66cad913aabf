// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "tegata/hull/octree.h"

namespace tegata {

/// The root cube of an octree: 2^depth cells a side, the first corner at `origin`.
struct OctreeRoot {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double cell_size = 0.0;  ///< [m]
  int depth = 2;           ///< at least 2

  std::int32_t cells() const { return std::int32_t{1} << depth; }
};

/// The root cube that build_octree() divides: centred on the region. Throws Error as it does.
OctreeRoot root_around(const Eigen::AlignedBox3d& region, double cell_size);

/// The field at the lattice points of a block of `Cells` cells a side, x fastest.
template <int Cells>
struct BlockValues {
  static constexpr std::size_t kSide = Cells + 1;
  static constexpr std::size_t kPoints = kSide * kSide * kSide;
  static constexpr std::size_t kLanes = (kPoints + 15) / 16 * 16;  ///< with room for vectors
  alignas(64) std::array<float, kLanes> field;
  std::array<std::uint8_t, kLanes> unproven;  ///< 1 where nothing proves what the field says
};

/// FieldSource for compilers: State is what a cube hands down to its eighths (copied to each), such
/// as what needs not be asked again. Cubes of kBlockCells cells a side (2 or 4) are not classified
/// further but sampled, with what is known of the block; a lattice point must have the same value
/// in every block that it belongs to.
template <typename Source>
concept OctreeSource = requires(Source& source, typename Source::State& state,
                                const Eigen::Vector3d& point, double half_side,
                                const LatticeIndex& low, BlockValues<Source::kBlockCells>& block) {
  { source.classify(point, half_side, state) } -> std::same_as<Occupancy>;
  source.sample(low, state, block);
};

/// Divides a cube depth first. The cells of sampled blocks are judged by their corners' signs.
template <OctreeSource Source>
class OctreeDivision {
 public:
  OctreeDivision(const OctreeRoot& root, Source& source) : root_(root), source_(source) {}

  SparseField run() {
    field_.origin = root_.origin;
    field_.cell_size = root_.cell_size;
    field_.levels.resize(static_cast<std::size_t>(root_.depth) + 1);
    // As many leaves as one of the cube's faces has cells: more than most surfaces need, and memory
    // that is not written to costs nothing.
    field_.leaves.reserve(std::size_t{1} << (2 * std::min(root_.depth, kMostReservedDepth)));
    visit({0, 0, 0}, 0, typename Source::State{});
    return std::move(field_);
  }

 private:
  static constexpr std::int32_t kCells = Source::kBlockCells;
  using Block = BlockValues<kCells>;
  static constexpr std::size_t kSide = Block::kSide;
  static_assert(kCells == 2 || kCells == 4);
  static constexpr int kMostReservedDepth = 9;
  // Of a row of cells; the baseline instruction set has no count of its own.
  static constexpr std::array<std::uint8_t, 16> kBitCount = {0, 1, 1, 2, 1, 2, 2, 3,
                                                             1, 2, 2, 3, 2, 3, 3, 4};

  void visit(const LatticeIndex& low, int level, typename Source::State state) {
    const std::int32_t side = root_.cells() >> level;
    const double half_side = 0.5 * side * root_.cell_size;
    SparseField::Level& counts = field_.levels[static_cast<std::size_t>(level)];
    ++counts.visited;
    const Eigen::Vector3d center = root_.origin +
                                   root_.cell_size * Eigen::Vector3d(low[0], low[1], low[2]) +
                                   Eigen::Vector3d::Constant(half_side);
    const Occupancy occupancy = source_.classify(center, half_side, state);
    if (occupancy == Occupancy::outside) {
      ++counts.outside;
    } else if (occupancy == Occupancy::inside && !touches_root_face(low, side)) {
      ++counts.inside;
    } else if (side == kCells) {
      sample_cells(low, level, state);
    } else {
      const std::int32_t half = side / 2;
      for (int i = 0; i < 8; ++i) {
        visit({low[0] + (i & 1) * half, low[1] + (i >> 1 & 1) * half, low[2] + (i >> 2) * half},
              level + 1, state);
      }
    }
  }

  void sample_cells(const LatticeIndex& low, int level, const typename Source::State& state) {
    source_.sample(low, state, block_);
    if (touches_root_face(low, kCells)) close_root_faces(low);
    for (int below = level + 1, cells = 8; below <= root_.depth; ++below, cells *= 8) {
      field_.levels[static_cast<std::size_t>(below)].visited += static_cast<std::size_t>(cells);
    }
    std::uint8_t unproven = 0;
    for (std::size_t i = 0; i < Block::kPoints; ++i) unproven |= block_.unproven[i];
    is_any_unproven_ = unproven != 0;
    // Along each row of points, bit x: inside.
    std::array<std::uint32_t, kSide * kSide> rows;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      rows[row] = 0;
      for (std::size_t x = 0; x < kSide; ++x) {
        rows[row] |= (block_.field[row * kSide + x] > 0.0f ? 1u : 0u) << x;
      }
    }
    constexpr std::uint32_t kEveryCell = (1u << kCells) - 1;
    SparseField::Level& counts = field_.levels.back();
    for (std::int32_t z = 0; z < kCells; ++z) {
      for (std::int32_t y = 0; y < kCells; ++y) {
        const std::size_t row = static_cast<std::size_t>(z) * kSide + static_cast<std::size_t>(y);
        const std::uint32_t any =
            rows[row] | rows[row + 1] | rows[row + kSide] | rows[row + kSide + 1];
        const std::uint32_t all =
            rows[row] & rows[row + 1] & rows[row + kSide] & rows[row + kSide + 1];
        const std::uint32_t some_inside = (any | any >> 1) & kEveryCell;
        const std::uint32_t whole = all & all >> 1 & kEveryCell;
        counts.outside += kCells - kBitCount[some_inside];
        counts.inside += kBitCount[whole];
        for (std::uint32_t crossed = some_inside & ~whole; crossed != 0; crossed &= crossed - 1) {
          add_leaf(low, {std::countr_zero(crossed), y, z});
        }
      }
    }
  }

  void add_leaf(const LatticeIndex& low, const LatticeIndex& cell) {
    OctreeLeaf& leaf = field_.leaves.emplace_back();
    leaf.index = {low[0] + cell[0], low[1] + cell[1], low[2] + cell[2]};
    const auto first =
        static_cast<std::size_t>(cell[0]) +
        kSide * (static_cast<std::size_t>(cell[1]) + kSide * static_cast<std::size_t>(cell[2]));
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t at = first + (i & 1) + kSide * ((i >> 1 & 1) + kSide * (i >> 2));
      leaf.field[i] = block_.field[at];
      if (is_any_unproven_) leaf.unproven |= block_.unproven[at] != 0;
    }
  }

  // Points on the root's faces count as outside.
  void close_root_faces(const LatticeIndex& low) {
    for (std::size_t i = 0; i < Block::kPoints; ++i) {
      const LatticeIndex point = {low[0] + static_cast<std::int32_t>(i % kSide),
                                  low[1] + static_cast<std::int32_t>(i / kSide % kSide),
                                  low[2] + static_cast<std::int32_t>(i / (kSide * kSide))};
      if (block_.field[i] > 0.0f && touches_root_face(point, 0)) {
        block_.field[i] = -static_cast<float>(root_.cell_size);
        block_.unproven[i] = 0;
      }
    }
  }

  // Whether a cube (a point, for side 0) reaches the faces on which everything is outside.
  bool touches_root_face(const LatticeIndex& low, std::int32_t side) const {
    for (const std::int32_t coordinate : low) {
      if (coordinate == 0 || coordinate + side == root_.cells()) return true;
    }
    return false;
  }

  OctreeRoot root_;
  Source& source_;
  Block block_;
  bool is_any_unproven_ = false;  ///< in block_
  SparseField field_;
};

}  // namespace tegata
