// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Where the forearm is when the hand is in a pose: what of the frame's hull lies behind the wrist,
/// as a body of rings about a straight axis from the wrist, in world coordinates [m]. The wrist
/// bends, so no pose of the hand tells. Nothing where there is no hull or too little of it there.
std::optional<TriangleMesh> find_forearm(const FitHand& hand, const FitFrame& frame,
                                         const Rigid3d& world_from_hand);

}  // namespace tegata
