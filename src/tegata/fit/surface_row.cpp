// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_row.h"

#include "tegata/hand/posed_rows.h"
#include "tegata/hand/skin_rows.h"

namespace tegata {
namespace {

void add_angles(const PosedRows& posed, std::size_t surface_row, const Eigen::Vector3d& along,
                HandRow& row) {
  const std::size_t part = posed.rows().part_of_row(surface_row);
  if (part == SkinRows::kPalmPart) return;
  const AngleColumns& columns = posed.columns(surface_row / kRowLanes);
  const std::size_t lane = surface_row % kRowLanes;
  const auto first = kPoseParameterCount + kAnglesPerDigit * static_cast<int>(part);
  for (int k = 0; k < kAnglesPerDigit; ++k) {
    const RowPoints& column = columns[static_cast<std::size_t>(k)];
    row.values[first + k] +=
        along.x() * column[0][lane] + along.y() * column[1][lane] + along.z() * column[2][lane];
  }
  row.digits |= DigitSet{1} << part;
}

}  // namespace

void add_vertex_row(const PosedHand& posed, std::size_t vertex, const Eigen::Vector3d& along,
                    HandRow& row) {
  const Eigen::Vector3d arm = posed.vertices()[vertex] - posed.pose().world_from_hand.translation;
  row.values.head<3>() += arm.cross(along).transpose();
  row.values.segment<3>(3) += along.transpose();
  const SkinRows& rows = posed.rows().rows();
  const SkinRows::SharedVertex* const shared = rows.shared(vertex);
  if (shared == nullptr) return add_angles(posed.rows(), rows.first_row(vertex), along, row);
  for (const std::uint32_t surface_row : shared->rows) {
    add_angles(posed.rows(), surface_row, along, row);
  }
}

}  // namespace tegata
