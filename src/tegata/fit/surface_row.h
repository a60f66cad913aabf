// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "tegata/fit/normal_equations.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// Adds d (along . vertex in world) / d pose and angles to a row: along^T times
/// PosedHand::vertex_jacobian(), without what is zero in it.
void add_vertex_row(const PosedHand& posed, std::size_t vertex, const Eigen::Vector3d& along,
                    HandRow& row);

}  // namespace tegata
