// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "tegata/hand/hand_model.h"
#include "tegata/sim/digit_closing.h"

namespace tegata {

enum class SimulatedGrasp {
  cylinder,  ///< power grasp around a cylinder of radius 20 to 35 mm
  sphere,    ///< all fingers around a ball of radius 28 to 40 mm
  pinch,     ///< thumb against index and middle finger on a disc or block 10 to 25 mm thick
  lateral,   ///< thumb against the side of the index finger on a plate 2 to 5 mm thick, like a key
};
std::string_view simulated_grasp_name(SimulatedGrasp grasp);
/// Throws Error listing the names that would do.
SimulatedGrasp simulated_grasp_from_name(std::string_view name);

/// A hand's angles and where the object lies in it.
struct Grasp {
  JointAngles angles = JointAngles::Zero();
  PlacedObject held;
};

/// Lays an object of seeded size into the hand and closes the digits on it, each from seeded
/// preferred angles, until they rest on its surface (GraspIt's closing of a hand, Miller and Allen
/// 2004, as a small minimisation). A left hand's grasp is the mirror image of the right hand's.
Grasp make_grasp(const HandModel& hand, SimulatedGrasp kind, std::uint64_t seed);

}  // namespace tegata
