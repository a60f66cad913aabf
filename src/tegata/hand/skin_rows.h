// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tegata/hand/hand_model.h"

namespace tegata {

/// So many rows make a block: loops over them are what the compiler makes vectors of.
inline constexpr std::size_t kRowLanes = 16;
using RowLanes = std::array<double, kRowLanes>;
using RowPoints = std::array<RowLanes, 3>;  ///< x, y, z

/// A hand's surface in the order in which it is posed by vector. A row is a vertex with one digit
/// that moves it: nearly every vertex has just one row, one that only the palm moves has one among
/// the palm's, one that several digits pull at (of an imported hand) has a row for each. The rows
/// of a digit follow each other, so that a block of them shares four bones and four angles, and
/// neither is ever looked up. Made once for a model.
class SkinRows {
 public:
  explicit SkinRows(const HandModel& model);

  struct alignas(64) Block {
    RowPoints position, normal;  ///< of the rest surface, in the hand's frame [m]
    /// Of the palm (0 in all rows of a vertex but its first) and of the digit's three bones.
    std::array<RowLanes, 4> weights;
  };
  /// The last block of a part repeats its last row up to the end.
  struct Part {
    std::size_t first = 0, last = 0;  ///< blocks, the last not included
  };
  static constexpr std::size_t kPalmPart = kDigitCount;

  std::size_t vertex_count() const { return first_row_.size(); }
  const std::vector<Block>& blocks() const { return blocks_; }
  /// The digits' and the palm's.
  const std::array<Part, kDigitCount + 1>& parts() const { return parts_; }
  /// Rows are counted through all blocks.
  std::size_t first_row(std::size_t vertex) const { return first_row_[vertex]; }
  /// Which part a row is in.
  std::size_t part_of_row(std::size_t row) const;

  /// The rows of a vertex that several digits move.
  struct SharedVertex {
    std::uint32_t vertex = 0;
    std::vector<std::uint32_t> rows;
  };
  /// In the order of their vertices.
  const std::vector<SharedVertex>& shared() const { return shared_; }
  const SharedVertex* shared(std::size_t vertex) const;

  /// A vertex next to no more than one joint: it moves with a bone and, in part, with the one that
  /// the bone hangs from. Nearly every vertex is one. In single precision, for sums over many: both
  /// are from the joint's centre (the hand's origin for the palm) to the vertex at rest, times how
  /// much the vertex moves with the bone and with the other one.
  struct HingedVertex {
    std::array<float, 3> beyond, before;  ///< [m]
  };
  const HingedVertex& hinged(std::size_t vertex) const { return hinged_[vertex]; }
  /// Its bone; kNoBone of a vertex that others move as well.
  std::size_t hinge(std::size_t vertex) const { return hinge_[vertex]; }
  static constexpr std::size_t kNoBone = kBoneCount;

 private:
  std::vector<Block> blocks_;
  std::array<Part, kDigitCount + 1> parts_;
  std::vector<std::uint32_t> first_row_;
  std::vector<SharedVertex> shared_;
  std::vector<HingedVertex> hinged_;
  std::vector<std::uint8_t> hinge_;
};

}  // namespace tegata
