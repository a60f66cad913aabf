// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "tegata/base/instruction_set.h"
#include "tegata/hand/skin_motion.h"
#include "tegata/hand/skin_rows.h"

namespace tegata {

/// d point / d the 4 angles of the rows' digit. By all 26 parameters a row's derivatives are zero,
/// whatever the pose, but for these and the 6 of the pose, which need no memory: a turn about the
/// axes e moves a vertex by e x position and its normal by e x normal, a shift by itself and 0.
using AngleColumns = std::array<RowPoints, 4>;

/// Rows put into a pose: world axes, but the hand's origin, so that rotation columns are products
/// with what is stored and a hand far from the world's origin loses nothing.
struct alignas(64) PosedPoints {
  RowPoints position;       ///< [m]
  RowPoints normal;         ///< of unit length; 0 where the rest surface's is
  RowLanes inverse_length;  ///< of the normal before it was made a unit vector; 0 where that was 0
};

/// Where a pose takes the rows of a surface, and the derivatives of vertices and normals, in blocks
/// of rows as SkinRows has them (linear blend skinning: all is closed form). Memory is kept from
/// pose to pose.
class PosedRows {
 public:
  /// Of the model that the rows are made of, whose surface is not looked at any more.
  PosedRows(std::shared_ptr<const SkinRows> rows, const HandModel& model);

  /// Every instruction set gives the same bits; it must be supported.
  void move_to(const HandPose& pose, InstructionSet set = best_instruction_set());

  const SkinRows& rows() const { return *rows_; }
  /// What has moved the rows.
  const SkinMotion& motion() const { return motion_; }
  /// Where a vertex that several digits move is, all its rows say alike.
  const PosedPoints& points(std::size_t block) const { return points_[block]; }
  /// Of vertices by the angles of the block's digit; only for blocks of digits, which come first. A
  /// vertex's derivatives by the angles of other digits are in its other rows.
  const AngleColumns& columns(std::size_t block) const { return columns_[block]; }
  /// The same of normals. Few ask for these: they are worked out when asked for.
  AngleColumns normal_columns(std::size_t block, InstructionSet set = best_instruction_set()) const;

 private:
  void sum_shared();

  std::shared_ptr<const SkinRows> rows_;
  SkinMotion motion_;
  std::unique_ptr<PosedPoints[]> points_;
  std::unique_ptr<AngleColumns[]> columns_;
};

}  // namespace tegata
