// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tegata/math/rigid3d.h"

namespace tegata {

/// How a hand turns in the middle of the room without changing its grasp. The world's origin is the
/// room's middle, z points up.
struct HandMotionOptions {
  int frame_count = 10;
  double turn_deg = 15.0;  ///< between successive frames, exactly
  std::uint64_t seed = 1;
};

/// world_from_hand for each frame. The forearm points up from one of the room's lower corners, so
/// that no camera of three looks along it; the hand turns mainly about the forearm (its y axis),
/// the axis swings smoothly, and `center_in_hand` [m] wanders within 2 cm of the room's middle.
std::vector<Rigid3d> hand_motion(const Eigen::Vector3d& center_in_hand,
                                 const HandMotionOptions& options);

}  // namespace tegata
