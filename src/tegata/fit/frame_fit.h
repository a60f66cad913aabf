// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "tegata/fit/solver.h"

namespace tegata {

/// The stages that a fit goes through, coarse to fine.
struct FitSchedule {
  std::vector<FitStage> stages;
};
/// Hull alone from far away, then hull and contours, then contours with the hull as a hint.
FitSchedule hull_first_schedule();
/// Contours from the beginning: for frames in which something cold has eaten the fingers, so that
/// the hull lacks them. Ends with the same stage as the other.
FitSchedule contour_first_schedule();
/// Both: for a hand that is far from where it is looked for, in whatever way.
std::vector<FitSchedule> search_schedules();
/// For the next frame of a stream, from where the hand is expected: contours, and few iterations.
/// Ends with the same stage as the two before.
FitSchedule follow_schedule();
/// The same for a stream that leaves no time for hulls.
FitSchedule stream_schedule();
/// For estimates that are already near.
FitSchedule grasp_schedule();
/// For estimates that are near, where what hides the hand is known: the hull, which lacks what is
/// hidden, is not asked.
FitSchedule object_schedule();
/// For estimates by a hand of another size, then of another shape.
FitSchedule scale_schedule();
FitSchedule shape_schedule();

/// How far the angles may leave what is known of them [rad], by stage; after the last entry the
/// last one holds.
using AngleDeviations = std::span<const double, 4>;
inline constexpr double kKnownDeviations[] = {0.02, 0.02, 0.02, 0.02};
/// The schedules with the angles held near known ones. Schedules may differ in length but end
/// alike, so the stages are counted from the end.
std::vector<FitSchedule> holding(std::vector<FitSchedule> schedules, const JointAngles& angles,
                                 AngleDeviations deviations);

/// Minimises by all stages of a schedule, one after the other (solver.h). The report is the last
/// stage's, with the iterations of all.
SolverReport minimise(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const FitSchedule& schedule, int threads, HandEstimate& estimate);

/// At most so many of `count` frames, one or more, spread over all.
std::vector<std::size_t> spread(std::size_t count, std::size_t most);

/// One hand found in one frame.
struct FrameFit {
  HandPose pose;
  SolverReport report;  ///< of the last stage; iterations of all
  /// The lowest energy that was reached elsewhere, keypoints more than 15 mm away on average, over
  /// this one's: near 1 nothing is proven. Infinite where all that was tried has come here.
  double lead = std::numeric_limits<double>::infinity();
};

/// Fits one frame from a start, through all stages of a schedule.
FrameFit fit_frame(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                   const FitSchedule& schedule, int threads = 1);

/// Fits one frame from several starts through several schedules; the lowest energy wins. Schedules
/// that differ end with the same two stages: what has come to the same place before these goes
/// on as one. Of more than `kept` starts only the best are followed after the first stage of the
/// first schedule.
FrameFit fit_frame_from_best(const FitHand& hand, const FitFrame& frame,
                             const std::vector<HandPose>& starts, std::size_t kept,
                             const std::vector<FitSchedule>& schedules, int threads);

/// The same from all starts_from_nothing() (start.h) with each of the given angles.
FrameFit fit_frame_from_nothing(const FitHand& hand, const FitFrame& frame,
                                const std::vector<JointAngles>& angles,
                                const std::vector<FitSchedule>& schedules, int threads);

}  // namespace tegata
