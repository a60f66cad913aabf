// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tegata/fit/solver.h"

namespace tegata {

/// The stages that a fit goes through, coarse to fine.
struct FitSchedule {
  std::vector<FitStage> stages;
};
/// Hull alone from far away, then hull and contours, then contours with the hull as a hint.
FitSchedule frame_schedule();
/// For estimates that are already near.
FitSchedule grasp_schedule();

/// One hand found in one frame.
struct FrameFit {
  HandPose pose;
  SolverReport report;  ///< of the last stage; iterations of all
};

/// Fits one frame from a start, through all stages of a schedule.
FrameFit fit_frame(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                   const FitSchedule& schedule);

/// Fits one frame from each of several starts: all go through the first stage, the `kept` best of
/// them through all; the one of the lowest energy wins.
FrameFit fit_frame_from_best(const FitHand& hand, const FitFrame& frame,
                             const std::vector<HandPose>& starts, std::size_t kept,
                             const FitSchedule& schedule, int threads);

}  // namespace tegata
