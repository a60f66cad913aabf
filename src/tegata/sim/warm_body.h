// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tegata/hand/hand_model.h"
#include "tegata/math/rigid3d.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// A surface that radiates by itself, as an infrared camera sees it.
struct WarmSurface {
  TriangleMesh mesh;
  std::vector<float>
      radiance;  ///< one a vertex; 0 is the darkest that a sensor shows, 1 the brightest
};

/// How warm the skin is at each of a model's vertices: 0.70 with slow variations, fingertips cooler
/// by up to 10 %. Fixed to the skin, whatever the pose.
std::vector<float> skin_radiance(const HandModel& hand, std::uint64_t seed);

/// A forearm in the hand's frame: a tapered elliptic tube that begins inside the stump of the
/// hand's rest surface, as wide as that, and ends 0.25 m beyond the wrist, bent by up to 15
/// degrees.
WarmSurface forearm_surface(const HandModel& hand, std::uint64_t seed);

/// Both in one, moved as said.
WarmSurface joined(const WarmSurface& a, const WarmSurface& b);
WarmSurface moved(const Rigid3d& b_from_a, WarmSurface surface_in_a);

}  // namespace tegata
