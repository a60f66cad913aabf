// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "tegata/base/observer.h"
#include "tegata/hand/hand_model.h"
#include "tegata/sim/grasps.h"

namespace tegata {

enum class SimulatedMode {
  infrared,  ///< warm hand, cold object that hides fingers and is nearly invisible
  mask,      ///< masks with 128 where the object stands, in front of the hand or beside it
  clean,     ///< masks of the hand alone, nothing in front of it
};
std::string_view simulated_mode_name(SimulatedMode mode);
/// Throws Error listing the names that would do.
SimulatedMode simulated_mode_from_name(std::string_view name);

struct SimulationOptions {
  SimulatedGrasp grasp = SimulatedGrasp::cylinder;
  SimulatedMode mode = SimulatedMode::infrared;
  Side side = Side::right;
  int camera_count = 3;  ///< 3: orthogonal axes, as in the paper, VI; more: spread around
  int frame_count = 10;
  std::uint64_t seed = 1;
  int width = 640, height = 480;  ///< pixels
  int bits = 8;                   ///< 8 or 16, infrared only
  double turn_deg = 15.0;         ///< of the hand between successive frames
  bool distortion = true;         ///< lenses as real ones
  bool forearm = true;            ///< warm as the hand: in images and masks, not in the truth
  bool initial_pose = true;       ///< write [initial_pose], rough by about 1 cm
  int threads = 0;
};

/// Makes a take of a hand that holds an object in a room of 1.5 x 1.5 x 2 m and turns it without
/// changing the grasp: images or masks, calibration, take.toml, and apart from them the truth. The
/// same hand and options give the same bytes whatever the number of threads. Throws Error where the
/// hand is not of the side asked for, an option is out of range, or the folder exists (unless
/// `replace`) or cannot be written.
void simulate_take(const HandModel& hand, const SimulationOptions& options,
                   const std::filesystem::path& folder, bool replace, const Observer& observer);

}  // namespace tegata
