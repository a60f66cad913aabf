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

// The schedules of a search end with so many stages in common.
constexpr std::size_t kCommonStages = 2;
// Estimates that are nearer to each other end alike: these are steps of a coarse stage.
constexpr double kAlikeTurn = 0.05;     // of the hand and of each joint [rad]
constexpr double kAlikeLength = 0.003;  // [m]

// A mean distance of keypoints [m] from which on another fit is no variant but another place.
constexpr double kElsewhere = 0.015;

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

bool is_alike(const HandPose& a, const HandPose& b, double scale) {
  const Rigid3d &here = a.world_from_hand, &there = b.world_from_hand;
  return here.rotation.angularDistance(there.rotation) < kAlikeTurn &&
         (here.translation - there.translation).norm() < kAlikeLength * scale &&
         (a.angles - b.angles).cwiseAbs().maxCoeff() < kAlikeTurn;
}

// A start on its way through a schedule.
struct Run {
  const FitSchedule* schedule;
  FrameFit fit;
};

// Of runs that have come to the same place the first one goes on.
void join_alike(std::vector<Run>& runs, double scale) {
  std::vector<Run> apart;
  for (Run& run : runs) {
    const auto joins = [&](const Run& other) {
      return is_alike(run.fit.pose, other.fit.pose, scale);
    };
    if (std::none_of(apart.begin(), apart.end(), joins)) apart.push_back(std::move(run));
  }
  runs = std::move(apart);
}

// Fits from all starts by all schedules, the lowest energy first.
std::vector<FrameFit> fit_all(const FitHand& hand, const FitFrame& frame,
                              const std::vector<HandPose>& starts,
                              const std::vector<FitSchedule>& schedules, int threads) {
  std::vector<Run> runs;
  std::size_t most_stages = 0;
  for (const HandPose& start : starts) {
    for (const FitSchedule& schedule : schedules) {
      runs.push_back({&schedule, {start, {}}});
      most_stages = std::max(most_stages, schedule.stages.size());
    }
  }
  for (std::size_t left = most_stages; left > 0; --left) {
    if (left <= kCommonStages && left < most_stages) join_alike(runs, hand.scale);
    parallel_for(runs.size(), threads, [&](std::size_t i) {
      const std::vector<FitStage>& stages = runs[i].schedule->stages;
      if (left > stages.size()) return;
      FrameFit& fit = runs[i].fit;
      const int iterations = fit.report.iterations;
      fit = fit_frame(hand, frame, fit.pose, FitSchedule{{stages[stages.size() - left]}}, threads);
      fit.report.iterations += iterations;
    });
  }
  std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return a.fit.report.energy < b.fit.report.energy;
  });
  std::vector<FrameFit> fits;
  for (Run& run : runs) fits.push_back(std::move(run.fit));
  return fits;
}

// The first of fits in the order of their energies, and how far it leads.
FrameFit winner_of(const FitHand& hand, std::vector<FrameFit> fits) {
  FrameFit winner = std::move(fits.front());
  const Skeleton& skeleton = hand.model->skeleton;
  const auto keypoints = posed_keypoints(skeleton, winner.pose);
  const auto is_elsewhere = [&](const FrameFit& other) {
    const auto there = posed_keypoints(skeleton, other.pose);
    double sum = 0.0;
    for (std::size_t k = 0; k < there.size(); ++k) sum += (there[k] - keypoints[k]).norm();
    return sum > kElsewhere * hand.scale * static_cast<double>(there.size());
  };
  const auto second = std::find_if(fits.begin() + 1, fits.end(), is_elsewhere);
  if (second != fits.end()) winner.lead = second->report.energy / winner.report.energy;
  return winner;
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
  if (starts.size() <= kept) {
    return winner_of(hand, fit_all(hand, frame, starts, schedules, threads));
  }
  const FitSchedule first{{schedules.front().stages.front()}};
  std::vector<HandPose> best;
  for (const FrameFit& fit : fit_all(hand, frame, starts, {first}, threads)) {
    if (best.size() < std::max<std::size_t>(kept, 1)) best.push_back(fit.pose);
  }
  return winner_of(hand, fit_all(hand, frame, best, schedules, threads));
}

FrameFit fit_frame_from_nothing(const FitHand& hand, const FitFrame& frame,
                                const std::vector<JointAngles>& angles,
                                const std::vector<FitSchedule>& schedules, int threads) {
  return fit_frame_from_best(hand, frame, starts_from_nothing(hand, frame, angles), kKeptStarts,
                             schedules, threads);
}

}  // namespace tegata
