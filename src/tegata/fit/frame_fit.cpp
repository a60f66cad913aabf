// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/frame_fit.h"

#include <algorithm>
#include <numeric>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/fit/start.h"

namespace tegata {
namespace {

// The mean squared residual of a term has this many independent residuals' worth: what weighs the
// images against the prior.
constexpr double kIndependentResiduals = 30.0;

// How many starts from nothing are followed to the end.
constexpr std::size_t kKeptStarts = 6;

// Contours with a wider kernel [m] are looked at less closely.
constexpr double kFineSigma = 0.004;

FitStage hull_stage(double sigma, int most_iterations) {
  FitStage stage;
  stage.hull = HullTermOptions{.sigma = sigma, .weight = kIndependentResiduals};
  stage.most_iterations = most_iterations;
  return stage;
}

FitStage contour_stage(double sigma, double violation_sigma, int most_iterations) {
  FitStage stage = hull_stage(0.006, most_iterations);
  stage.hull->weight *= 0.3;
  stage.contour = ContourTermOptions{.sigma = sigma,
                                     .violation_sigma = violation_sigma,
                                     .weight = kIndependentResiduals,
                                     .coarseness = sigma > kFineSigma ? 2 : 1};
  return stage;
}

FitStage with_landmarks(FitStage stage, double weight) {
  stage.landmarks = LandmarkTermOptions{.weight = weight};
  return stage;
}

}  // namespace

FitSchedule hull_first_schedule() {
  return {{with_landmarks(hull_stage(0.03, 12), 10.0), with_landmarks(hull_stage(0.012, 15), 10.0),
           with_landmarks(contour_stage(0.008, 0.016, 12), 3.0), contour_stage(0.003, 0.01, 15)}};
}

FitSchedule contour_first_schedule() {
  return {{with_landmarks(contour_stage(0.02, 0.03, 15), 10.0),
           with_landmarks(contour_stage(0.008, 0.016, 12), 3.0), contour_stage(0.003, 0.01, 15)}};
}

std::vector<FitSchedule> search_schedules() {
  return {hull_first_schedule(), contour_first_schedule()};
}

FitSchedule follow_schedule() {
  FitStage coarse = contour_stage(0.008, 0.016, 6);
  coarse.hull.reset();
  return {{coarse, contour_stage(0.003, 0.01, 8)}};
}

FitSchedule stream_schedule() {
  FitStage coarse = contour_stage(0.01, 0.02, 4), fine = contour_stage(0.003, 0.01, 5);
  coarse.hull.reset();
  fine.hull.reset();
  return {{coarse, fine}};
}

FitSchedule grasp_schedule() {
  return {{contour_stage(0.006, 0.012, 15), contour_stage(0.0025, 0.008, 25)}};
}

FitSchedule object_schedule() {
  FitSchedule schedule = grasp_schedule();
  for (FitStage& stage : schedule.stages) stage.hull.reset();
  return schedule;
}

FitSchedule scale_schedule() {
  return {{contour_stage(0.016, 0.024, 20), contour_stage(0.008, 0.016, 20)}};
}

FitSchedule shape_schedule() {
  return {{contour_stage(0.008, 0.016, 20), contour_stage(0.004, 0.01, 30)}};
}

std::vector<FitSchedule> holding(std::vector<FitSchedule> schedules, const JointAngles& angles,
                                 AngleDeviations deviations) {
  for (FitSchedule& schedule : schedules) {
    const std::size_t count = schedule.stages.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from_end = std::min(count - 1 - i, deviations.size() - 1);
      schedule.stages[i].prior.previous = angles;
      schedule.stages[i].prior.previous_standard_deviations.setConstant(
          deviations[deviations.size() - 1 - from_end]);
    }
  }
  return schedules;
}

SolverReport minimise(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const FitSchedule& schedule, int threads, HandEstimate& estimate) {
  SolverReport report;
  int iterations = 0;
  for (const FitStage& stage : schedule.stages) {
    report = minimise(hand, frames, stage, threads, estimate);
    iterations += report.iterations;
  }
  report.iterations = iterations;
  return report;
}

std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t kept = std::min(count, most);
  for (std::size_t i = 0; i < kept; ++i) {
    chosen.push_back(kept == 1 ? 0 : i * (count - 1) / (kept - 1));
  }
  return chosen;
}

FrameFit fit_frame(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                   const FitSchedule& schedule, int threads) {
  HandEstimate estimate{start.angles, {start.world_from_hand}};
  const FitFrame* const frames[] = {&frame};
  FrameFit fit;
  fit.report = minimise(hand, frames, schedule, threads, estimate);
  fit.pose = estimate.pose(0);
  return fit;
}

FrameFit fit_frame_from_best(const FitHand& hand, const FitFrame& frame,
                             const std::vector<HandPose>& starts, std::size_t kept,
                             const std::vector<FitSchedule>& schedules, int threads) {
  if (starts.empty() || schedules.empty() || schedules.front().stages.empty()) {
    throw Error("frame fit: got ", starts.size(), " starts and ", schedules.size(),
                " schedules, expected at least one of each, and a stage");
  }
  const auto fit_all = [&](const std::vector<HandPose>& from, const std::vector<FitSchedule>& by) {
    std::vector<FrameFit> fits(from.size() * by.size());
    parallel_for(fits.size(), threads, [&](std::size_t i) {
      fits[i] = fit_frame(hand, frame, from[i / by.size()], by[i % by.size()]);
    });
    std::stable_sort(fits.begin(), fits.end(), [](const FrameFit& a, const FrameFit& b) {
      return a.report.energy < b.report.energy;
    });
    return fits;
  };
  if (starts.size() <= kept) return fit_all(starts, schedules).front();
  std::vector<HandPose> best;
  for (const FrameFit& fit : fit_all(starts, {{{schedules.front().stages.front()}}})) {
    if (best.size() < std::max<std::size_t>(kept, 1)) best.push_back(fit.pose);
  }
  return fit_all(best, schedules).front();
}

FrameFit fit_frame_from_nothing(const FitHand& hand, const FitFrame& frame,
                                const std::vector<JointAngles>& angles,
                                const std::vector<FitSchedule>& schedules, int threads) {
  return fit_frame_from_best(hand, frame, starts_from_nothing(hand, frame, angles), kKeptStarts,
                             schedules, threads);
}

}  // namespace tegata
