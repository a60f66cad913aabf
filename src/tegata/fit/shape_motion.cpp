// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/shape_motion.h"

namespace tegata {

ShapeRow ScaleMotion::row(std::size_t vertex, const Eigen::RowVector3d& along) const {
  const Eigen::Vector3d from_origin =
      posed_->vertices()[vertex] - posed_->pose().world_from_hand.translation;
  return ShapeRow::Constant(1, along.dot(from_origin) / scale_);
}

ShapeRow ParameterMotion::row(std::size_t vertex, const Eigen::RowVector3d& along) const {
  return along * shape_.vertex_jacobian(vertex);
}

}  // namespace tegata
