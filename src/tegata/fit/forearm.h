// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Bodies of rings about a straight axis from the wrist, in world coordinates [m].
struct Forearm {
  TriangleMesh surface;
  TriangleMesh beyond;  ///< where the arm goes on, behind the hull's end
};

/// Where the forearm is when the hand is in a pose: what of the frame's hull lies behind the wrist.
/// The wrist bends, so no pose of the hand tells. Nothing where there is no hull or too little of
/// it there.
std::optional<Forearm> find_forearm(const FitHand& hand, const FitFrame& frame,
                                    const Rigid3d& world_from_hand);

}  // namespace tegata
