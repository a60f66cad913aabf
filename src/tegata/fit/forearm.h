// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// A body of rings about a straight axis from the wrist, in world coordinates [m].
struct Forearm {
  TriangleMesh surface;
  Eigen::Vector3d end;  ///< of the axis, where the hull ends
};

/// Where the forearm is when the hand is in a pose: what of the frame's hull lies behind the wrist.
/// The wrist bends, so no pose of the hand tells. Nothing where there is no hull or too little of
/// it there.
std::optional<Forearm> find_forearm(const FitHand& hand, const FitFrame& frame,
                                    const Rigid3d& world_from_hand);

}  // namespace tegata
