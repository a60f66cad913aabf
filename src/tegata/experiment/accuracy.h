// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// How close the default method comes: a fixed suite of takes in the virtual room, whose seeds are
// 1, 2, ... for each grasp, so that anybody can repeat it.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/sim/virtual_room.h"

namespace tegata {

/// What the cameras give: infrared pictures in which the object is not seen, masks that mark it as
/// unknown, masks of a hand with nothing in front of it.
inline constexpr std::array<SimulatedMode, 3> kAccuracyModes = {
    SimulatedMode::infrared, SimulatedMode::mask, SimulatedMode::clean};

struct AccuracyOptions {
  std::vector<SimulatedMode> modes = {kAccuracyModes.begin(), kAccuracyModes.end()};
  int seed_count = 5;  ///< of each grasp and mode: seeds 1 to this
  int frame_count = 10;
  int width = 640, height = 480;  ///< of the pictures [px]
  int threads = 0;
  std::filesystem::path folder;  ///< an existing one, for the takes while they are looked at
};

/// How far a fit is from the truth, mean over the frames.
struct TakeAccuracy {
  double surface_mm = 0.0, angle_deg = 0.0, thumb_deg = 0.0;
  double share_within = 0.0;  ///< of the true angles, within one of the stated deviations
};

struct Accuracy {
  int seed_count = 0, frame_count = 0;
  /// Of the first grasp all seeds, then of the second.
  std::map<SimulatedMode, std::vector<TakeAccuracy>> takes;
};

/// Mean, median (the upper one of two) and greatest.
struct ErrorRange {
  double mean = 0.0, median = 0.0, worst = 0.0;
};
/// Throws Error for no takes.
ErrorRange error_range(const std::vector<TakeAccuracy>& takes, double TakeAccuracy::*measure);

/// Makes takes of three cameras on orthogonal axes, of the grasps of Table I (table1.h), rough
/// landmarks of the first frame given, fits each by the default method and compares with the truth.
/// The same hand is in the pictures and in the fit. Takes are worked on in parallel, each by one
/// thread. Throws Error for no modes, seeds or frames.
Accuracy run_accuracy(const AccuracyOptions& options, const Observer& observer);

std::string accuracy_text(const Accuracy& accuracy);
/// The same and the figures of each take.
std::string accuracy_json(const Accuracy& accuracy);

}  // namespace tegata
