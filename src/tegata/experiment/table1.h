// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The experiment of Table I of K. Ogawara, K. Hashimoto, J. Takamatsu, K. Ikeuchi, "Grasp
// Recognition using a 3D Articulated Model and Infrared Images" (2003), in the virtual room.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/experiment/weight_chart.h"
#include "tegata/sim/grasps.h"

namespace tegata {

/// Power, precision and lateral.
inline constexpr std::array<SimulatedGrasp, 3> kTable1Grasps = {
    SimulatedGrasp::cylinder, SimulatedGrasp::pinch, SimulatedGrasp::lateral};

/// How a take was fitted: by whom, and whether every frame has angles of its own.
enum class Table1Fit { paper_single, paper_all, default_single, default_all };
inline constexpr std::size_t kTable1FitCount = 4;
std::string_view table1_fit_name(Table1Fit fit);

struct Table1Options {
  int seed_count = 10;  ///< seeds 1 to this
  int frame_count = 5;
  int width = 640, height = 480;  ///< of the pictures [px]
  int threads = 0;
  std::filesystem::path folder;  ///< an existing one, for the takes while they are looked at
};

/// How far one fit is from the truth, mean over the frames, as `tegata evaluate` measures it.
struct FitError {
  double surface_mm = 0.0, angle_deg = 0.0;
};
/// Mean and standard deviation over the seeds; 0 with one seed.
struct ErrorSpread {
  FitError mean, deviation;
};

struct Table1 {
  int seed_count = 0, frame_count = 0;
  /// By grasp, in the order of kTable1Grasps, then by fit, in the order of Table1Fit.
  std::array<std::array<ErrorSpread, kTable1FitCount>, kTable1Grasps.size()> errors;
  /// And of each seed.
  std::array<std::array<std::vector<FitError>, kTable1FitCount>, kTable1Grasps.size()> of_seeds;
  WeightRecord weights;  ///< of the paper's method: the first grasp's first seed
};

/// What the paper states: from the least to the greatest of its three grasps.
inline constexpr FitError kPaperLeast = {8.3, 13.5}, kPaperGreatest = {10.9, 18.2};

/// The mean and the standard deviation of some.
ErrorSpread spread_of(const std::vector<FitError>& errors);

/// Makes takes of three infrared cameras on orthogonal axes, rough landmarks of the first frame
/// given, fits each by both methods and compares with the truth. The same hand is in the pictures
/// and in the fit. Takes are worked on in parallel, each by one thread.
Table1 run_table1(const Table1Options& options, const Observer& observer);

}  // namespace tegata
