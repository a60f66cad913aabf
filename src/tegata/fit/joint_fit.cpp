// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/joint_fit.h"

#include <optional>
#include <utility>
#include <vector>

#include "tegata/fit/digit_search.h"
#include "tegata/fit/surroundings.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// A frame whose energy is so many times the median of all frames is sought anew.
constexpr double kSuspectEnergyRatio = 1.3;
// A pose that is farther than this from where an evenly moving hand would have it is sought there.
constexpr double kJumpAngle = 0.06;    // [rad]
constexpr double kJumpLength = 0.005;  // [m]

// Seeks the frames that fit worse than most anew, with the angles known, from their neighbours'
// poses. True where any was found elsewhere.
bool seek_suspects(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const std::vector<double>& energies, const JointFitOptions& options,
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
                const HiddenObject& object, const JointFitOptions& options,
                HandEstimate& estimate) {
  if (frames.size() < 3) return;
  const std::vector<Rigid3d> poses = estimate.world_from_hand;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const Rigid3d expected = expected_pose(poses, f);
    if (expected.rotation.angularDistance(poses[f].rotation) < kJumpAngle &&
        (expected.translation - poses[f].translation).norm() < kJumpLength * hand.scale) {
      continue;
    }
    const FrameFit there =
        fit_known(hand, *frames[f], {expected, estimate.angles}, object, options);
    const FrameFit here = fit_known(hand, *frames[f], {poses[f], estimate.angles}, object, options);
    if (there.report.energy < here.report.energy) {
      estimate.world_from_hand[f] = there.pose.world_from_hand;
    }
  }
}

// Lets all frames settle by a schedule and seeks suspects anew; with `reseats` fingers are tried in
// other places as well.
SolverReport settle(const FitHand& hand, std::span<const FitFrame* const> frames,
                    const FitSchedule& schedule, bool reseats, const JointFitOptions& options,
                    HandEstimate& estimate) {
  SolverReport report = minimise(hand, frames, schedule, options.threads, estimate);
  int iterations = report.iterations;
  if (reseats) {
    if (const std::optional<SolverReport> better =
            reseat_digits(hand, frames, schedule, options.threads, estimate)) {
      report = *better;
      iterations += report.iterations;
    }
  }
  if (seek_suspects(hand, frames, report.frame_energies, options, estimate)) {
    report = minimise(hand, frames, schedule, options.threads, estimate);
    iterations += report.iterations;
  }
  report.iterations = iterations;
  return report;
}

}  // namespace

// Where the hand would be if it went on as it went from the frame before the last to the last.
Rigid3d extrapolated(const Rigid3d& before, const Rigid3d& last) {
  const Eigen::Quaterniond turn = last.rotation * before.rotation.conjugate();
  return {(turn * last.rotation).normalized(), 2.0 * last.translation - before.translation};
}

FrameFit fit_known(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                   const HiddenObject& object, const JointFitOptions& options) {
  const FitSchedule schedule =
      holding({options.with_object}, start.angles, kKnownDeviations).front();
  const FitFrame* const one[] = {&frame};
  const std::vector<FitFrame> surrounded =
      with_surroundings(hand, one, {start.angles, {start.world_from_hand}}, object.surface, 1);
  return fit_frame(hand, surrounded.front(), start, schedule);
}

JointFit fit_jointly(const FitHand& hand, std::span<const FitFrame* const> frames,
                     HandEstimate start, const JointFitOptions& options, const Observer& observer) {
  JointFit fit;
  fit.estimate = std::move(start);
  HandEstimate& estimate = fit.estimate;
  const auto rounds = static_cast<std::size_t>(options.object_rounds) + 1;
  std::vector<FitFrame> surrounded;
  int iterations = 0;
  // Draws what is known to stand about the hand anew and lets all settle among it.
  const auto settle_among = [&](const FitSchedule& schedule, bool reseats) {
    surrounded = with_surroundings(hand, frames, estimate, fit.object.surface, options.threads);
    fit.report = settle(hand, pointers_to(surrounded), schedule, reseats, options, estimate);
    iterations += fit.report.iterations;
  };
  observer.progress("all frames", 0, rounds);
  settle_among(options.all_frames, false);
  for (std::size_t round = 1; round < rounds; ++round) {
    observer.progress("all frames", round, rounds);
    surrounded = with_surroundings(hand, frames, estimate, {}, options.threads);
    fit.object = find_hidden_object(hand, pointers_to(surrounded), estimate, options.object,
                                    options.threads);
    seek_jumps(hand, frames, fit.object, options, estimate);
    const bool is_any = !fit.object.surface.triangles.empty();
    settle_among(is_any ? options.with_object : options.all_frames, round == 1);
    if (!is_any && round > 1) break;
  }
  observer.progress("all frames", rounds, rounds);
  fit.report.iterations = iterations;
  return fit;
}

}  // namespace tegata
