// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/grasp_fit.h"

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/digit_search.h"
#include "tegata/fit/surroundings.h"

namespace tegata {
namespace {

// How many of the first frame's starts are followed to the end.
constexpr std::size_t kKeptStarts = 6;
// A frame whose energy is so many times the median of all frames is sought anew.
constexpr double kSuspectEnergyRatio = 1.3;
// A tracked frame whose energy is so many times the median of those before may be lost.
constexpr double kLostEnergyRatio = 2.0;
// From the normal equations' deviations to true ones: neighbouring residuals are not independent.
// Measured: over 15 simulated takes (three grasps, five seeds, three infrared cameras, ten frames)
// 68 % of the true angles lie within one deviation.
constexpr double kDeviationScale = 2.2;
// A pose that is farther than this from where an evenly moving hand would have it is sought there.
constexpr double kJumpAngle = 0.06;    // [rad]
constexpr double kJumpLength = 0.005;  // [m]
// How far the angles may leave what is known of them [rad], stage by stage: a turning hand is first
// followed nearly stiff, as nothing else moves the fingers' surfaces as far. After the last entry
// the last one holds.
constexpr double kFixedDeviations[] = {0.03, 0.06, 0.1, 0.15};
constexpr double kFreeDeviations[] = {0.1, 0.15, 0.2, 0.3};
constexpr double kKnownDeviations[] = {0.02, 0.02, 0.02, 0.02};

using Deviations = std::span<const double, 4>;

std::vector<HandPose> starts_from_nothing(const FitHand& hand, const FitFrame& frame,
                                          const std::vector<JointAngles>& angles) {
  const std::vector<Rigid3d> poses =
      frame.landmarks
          ? std::vector<Rigid3d>{pose_from_landmarks(hand.model->skeleton, *frame.landmarks)}
          : poses_at_ends(hand, hand_ends(hand, frame));
  std::vector<HandPose> starts;
  for (const Rigid3d& pose : poses) {
    for (const JointAngles& bent : angles) starts.push_back({pose, bent});
  }
  return starts;
}

// Where the hand would be if it went on as it went from the frame before the last to the last.
Rigid3d extrapolated(const Rigid3d& before, const Rigid3d& last) {
  const Eigen::Quaterniond turn = last.rotation * before.rotation.conjugate();
  return {(turn * last.rotation).normalized(), 2.0 * last.translation - before.translation};
}

std::vector<FitSchedule> holding(std::vector<FitSchedule> schedules, const JointAngles& angles,
                                 Deviations deviations) {
  for (FitSchedule& schedule : schedules) {
    // Schedules may differ in length but end alike, so the stages are counted from the end.
    const std::size_t count = schedule.stages.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from_end = std::min(count - 1 - i, deviations.size() - 1);
      schedule.stages[i].prior.previous = angles;
      schedule.stages[i].prior.previous_standard_deviation =
          deviations[deviations.size() - 1 - from_end];
    }
  }
  return schedules;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A frame after the first: from where the hand was or would be and, where that fits far worse than
// the frames before did, from nothing: the hand may have been lost.
FrameFit fit_next(const FitHand& hand, const FitFrame& frame, const std::vector<FrameFit>& before,
                  const std::vector<double>& energies, const GraspFitOptions& options) {
  const HandPose& last = before.back().pose;
  std::vector<HandPose> starts = {last};
  if (before.size() > 1) {
    const HandPose& last_but_one = before[before.size() - 2].pose;
    starts.push_back(
        {extrapolated(last_but_one.world_from_hand, last.world_from_hand), last.angles});
  }
  const std::vector<FitSchedule> schedules =
      holding(options.frame, last.angles,
              options.grasp == GraspConstraint::free ? Deviations(kFreeDeviations)
                                                     : Deviations(kFixedDeviations));
  const FrameFit tracked =
      fit_frame_from_best(hand, frame, starts, starts.size(), schedules, options.threads);
  if (tracked.report.energy <= kLostEnergyRatio * median(energies)) return tracked;
  const FrameFit found =
      fit_frame_from_best(hand, frame, starts_from_nothing(hand, frame, {last.angles}), kKeptStarts,
                          schedules, options.threads);
  return found.report.energy < tracked.report.energy ? found : tracked;
}

// The fits of all frames one after the other.
std::vector<FrameFit> fit_in_order(const FitHand& hand, std::span<const FitFrame* const> frames,
                                   const GraspFitOptions& options, const Observer& observer) {
  std::vector<FrameFit> fits;
  std::vector<double> energies;
  for (const FitFrame* frame : frames) {
    observer.progress("frames", fits.size(), frames.size());
    fits.push_back(fits.empty()
                       ? fit_frame_from_best(hand, *frame,
                                             starts_from_nothing(hand, *frame, typical_angles()),
                                             kKeptStarts, options.frame, options.threads)
                       : fit_next(hand, *frame, fits, energies, options));
    energies.push_back(fits.back().report.energy);
  }
  observer.progress("frames", frames.size(), frames.size());
  return fits;
}

HandEstimate median_estimate(const std::vector<FrameFit>& fits) {
  HandEstimate estimate;
  for (int k = 0; k < kAngleCount; ++k) {
    std::vector<double> values;
    for (const FrameFit& fit : fits) values.push_back(fit.pose.angles[k]);
    estimate.angles[k] = median(std::move(values));
  }
  for (const FrameFit& fit : fits) estimate.world_from_hand.push_back(fit.pose.world_from_hand);
  return estimate;
}

JointAngles standard_deviations(const SolverReport& report) {
  return kDeviationScale * report.angle_covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

SolverReport fit_together(const FitHand& hand, std::span<const FitFrame* const> frames,
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

// Seeks the frames that fit worse than most anew, with the angles known, from their neighbours'
// poses. True where any was found elsewhere.
bool seek_suspects(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const std::vector<double>& energies, const GraspFitOptions& options,
                   HandEstimate& estimate) {
  const double limit = kSuspectEnergyRatio * median(energies);
  const std::vector<FitSchedule> schedules =
      holding(options.frame, estimate.angles, kKnownDeviations);
  bool is_any_elsewhere = false;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (energies[f] <= limit) continue;
    std::vector<HandPose> starts = {estimate.pose(f)};
    if (f > 0) starts.push_back(estimate.pose(f - 1));
    if (f + 1 < frames.size()) starts.push_back(estimate.pose(f + 1));
    const Rigid3d found =
        fit_frame_from_best(hand, *frames[f], starts, starts.size(), schedules, options.threads)
            .pose.world_from_hand;
    constexpr double kElsewhere = 0.1;  // [rad]
    if (found.rotation.angularDistance(estimate.world_from_hand[f].rotation) > kElsewhere) {
      estimate.world_from_hand[f] = found;
      is_any_elsewhere = true;
    }
  }
  return is_any_elsewhere;
}

// Where a frame's pose would be if the hand moved evenly through its neighbours; at either end, if
// it went on as it goes between the two next ones.
Rigid3d expected_pose(const std::vector<Rigid3d>& poses, std::size_t f) {
  const std::size_t last = poses.size() - 1;
  if (f == 0) return extrapolated(poses[2], poses[1]);
  if (f == last) return extrapolated(poses[last - 2], poses[last - 1]);
  const Rigid3d &before = poses[f - 1], &after = poses[f + 1];
  return {before.rotation.slerp(0.5, after.rotation),
          0.5 * (before.translation + after.translation)};
}

// Seeks frames that a hand which moves evenly would have elsewhere from there, with the angles and
// the object known: what hides the hand may look as if the hand were beside where it is.
void seek_jumps(const FitHand& hand, std::span<const FitFrame* const> frames,
                const HiddenObject& object, const GraspFitOptions& options,
                HandEstimate& estimate) {
  if (frames.size() < 3) return;
  const FitSchedule schedule =
      holding({options.with_object}, estimate.angles, kKnownDeviations).front();
  const auto fit_from = [&](std::size_t f, const Rigid3d& start) {
    const FitFrame* const one[] = {frames[f]};
    const std::vector<FitFrame> surrounded =
        with_surroundings(hand, one, {estimate.angles, {start}}, object.surface, options.threads);
    return fit_frame(hand, surrounded.front(), {start, estimate.angles}, schedule);
  };
  const std::vector<Rigid3d> poses = estimate.world_from_hand;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const Rigid3d expected = expected_pose(poses, f);
    if (expected.rotation.angularDistance(poses[f].rotation) < kJumpAngle &&
        (expected.translation - poses[f].translation).norm() < kJumpLength * hand.scale) {
      continue;
    }
    const FrameFit there = fit_from(f, expected), here = fit_from(f, poses[f]);
    if (there.report.energy < here.report.energy) {
      estimate.world_from_hand[f] = there.pose.world_from_hand;
    }
  }
}

// Lets all frames settle by a schedule and seeks suspects anew; with `reseats` fingers are tried in
// other places as well.
SolverReport settle(const FitHand& hand, std::span<const FitFrame* const> frames,
                    const FitSchedule& schedule, bool reseats, const GraspFitOptions& options,
                    HandEstimate& estimate) {
  SolverReport report = fit_together(hand, frames, schedule, options.threads, estimate);
  int iterations = report.iterations;
  if (reseats) {
    if (const std::optional<SolverReport> better =
            reseat_digits(hand, frames, schedule, options.threads, estimate)) {
      report = *better;
      iterations += report.iterations;
    }
  }
  if (seek_suspects(hand, frames, report.frame_energies, options, estimate)) {
    report = fit_together(hand, frames, schedule, options.threads, estimate);
    iterations += report.iterations;
  }
  report.iterations = iterations;
  return report;
}

void fit_all_frames(const FitHand& hand, std::span<const FitFrame* const> frames,
                    const std::vector<FrameFit>& fits, const GraspFitOptions& options,
                    GraspFit& grasp) {
  HandEstimate estimate = median_estimate(fits);
  std::vector<FitFrame> surrounded;
  // Draws what is known to stand about the hand anew and lets all settle among it.
  const auto settle_among = [&](const FitSchedule& schedule, bool reseats) {
    surrounded = with_surroundings(hand, frames, estimate, grasp.object.surface, options.threads);
    const SolverReport report =
        settle(hand, pointers_to(surrounded), schedule, reseats, options, estimate);
    grasp.iterations += report.iterations;
    return report;
  };
  SolverReport report = settle_among(options.all_frames, false);
  for (int round = 0; round < options.object_rounds; ++round) {
    surrounded = with_surroundings(hand, frames, estimate, {}, options.threads);
    grasp.object = find_hidden_object(hand, pointers_to(surrounded), estimate, options.object,
                                      options.threads);
    seek_jumps(hand, frames, grasp.object, options, estimate);
    const bool is_any = !grasp.object.surface.triangles.empty();
    report = settle_among(is_any ? options.with_object : options.all_frames, round == 0);
    if (!is_any && round > 0) break;
  }
  grasp.termination = report.termination;
  grasp.standard_deviations = standard_deviations(report);
  grasp.angles = estimate.angles;
  for (std::size_t f = 0; f < frames.size(); ++f) grasp.poses.push_back(estimate.pose(f));
}

// Every frame on its own: the mean of the angles and their spread stand for the grasp.
void keep_frames_free(const std::vector<FrameFit>& fits, GraspFit& grasp) {
  const double count = static_cast<double>(fits.size());
  grasp.angles.setZero();
  for (const FrameFit& fit : fits) {
    grasp.poses.push_back(fit.pose);
    grasp.angles += fit.pose.angles / count;
    grasp.iterations += fit.report.iterations;
  }
  JointAngles variance = JointAngles::Zero();
  for (const FrameFit& fit : fits) {
    variance += ((fit.pose.angles - grasp.angles).cwiseAbs2() +
                 standard_deviations(fit.report).cwiseAbs2()) /
                count;
  }
  grasp.standard_deviations = variance.cwiseSqrt();
  grasp.termination = fits.back().report.termination;
}

}  // namespace

GraspFit fit_grasp(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const GraspFitOptions& options, const Observer& observer) {
  if (frames.empty()) throw Error("grasp fit: got no frame, expected at least one");
  for (const FitFrame* frame : frames) {
    if (!frame->hull) throw Error("grasp fit: got a frame without a hull, expected one for each");
  }
  GraspFit grasp;
  const Stopwatch frame_watch;
  const std::vector<FrameFit> fits = fit_in_order(hand, frames, options, observer);
  grasp.frame_seconds = frame_watch.seconds();
  const Stopwatch grasp_watch;
  if (options.grasp == GraspConstraint::free) {
    keep_frames_free(fits, grasp);
  } else {
    observer.progress("all frames", 0, 1);
    fit_all_frames(hand, frames, fits, options, grasp);
    observer.progress("all frames", 1, 1);
  }
  grasp.all_frames_seconds = grasp_watch.seconds();
  return grasp;
}

}  // namespace tegata
