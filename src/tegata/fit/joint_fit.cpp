// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/joint_fit.h"

#include <optional>
#include <utility>
#include <vector>

#include "tegata/base/parallel.h"
#include "tegata/fit/contradiction.h"
#include "tegata/fit/digit_search.h"
#include "tegata/fit/known_grasp.h"
#include "tegata/fit/surroundings.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// A frame whose energy is so many times the median of all frames is sought anew.
constexpr double kSuspectEnergyRatio = 1.3;
// A pose that is farther than this from where an evenly moving hand would have it is sought there.
constexpr double kJumpAngle = 0.04;    // [rad]
constexpr double kJumpLength = 0.003;  // [m]

// Seeks the frames that fit worse than most anew, with the angles known, from their neighbours'
// poses; those in `settled` were found nowhere else before. True where any was found elsewhere.
bool seek_suspects(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const std::vector<double>& energies, const JointFitOptions& options,
                   std::vector<bool>& settled, HandEstimate& estimate) {
  const double limit = kSuspectEnergyRatio * median(energies);
  const std::vector<FitSchedule> schedules =
      holding(options.frame, estimate.angles, kKnownDeviations);
  bool is_any_elsewhere = false;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (energies[f] <= limit || settled[f]) continue;
    std::vector<HandPose> starts = {estimate.pose(f)};
    if (f > 0) starts.push_back(estimate.pose(f - 1));
    if (f + 1 < frames.size()) starts.push_back(estimate.pose(f + 1));
    const Rigid3d found =
        fit_frame_from_best(hand, *frames[f], starts, starts.size(), schedules, options.threads)
            .pose.world_from_hand;
    constexpr double kElsewhere = 0.1;  // [rad]
    settled[f] = true;
    if (found.rotation.angularDistance(estimate.world_from_hand[f].rotation) > kElsewhere) {
      estimate.world_from_hand[f] = found;
      settled[f] = false;
      is_any_elsewhere = true;
    }
  }
  return is_any_elsewhere;
}

// Half-way from one pose to another along the screw motion that leads there.
Rigid3d half_way(const Rigid3d& before, const Rigid3d& after) {
  const Rigid3d motion = before.inverse() * after;
  const Eigen::Quaterniond half_turn = Eigen::Quaterniond::Identity().slerp(0.5, motion.rotation);
  // The half applied twice is the whole: t + R t = motion.translation.
  const Eigen::Matrix3d twice = Eigen::Matrix3d::Identity() + half_turn.toRotationMatrix();
  return before * Rigid3d{half_turn, twice.inverse() * motion.translation};
}

// Where a frame's pose would be if the hand moved evenly through its neighbours; at either end, if
// it went on as it goes between the two next ones.
Rigid3d expected_pose(const std::vector<Rigid3d>& poses, std::size_t f) {
  const std::size_t last = poses.size() - 1;
  if (f == 0) return extrapolated(poses[2], poses[1]);
  if (f == last) return extrapolated(poses[last - 2], poses[last - 1]);
  return half_way(poses[f - 1], poses[f + 1]);
}

// Seeks frames that a hand which moves evenly would have elsewhere from there, with the angles and
// the object known: what hides the hand may look as if the hand were beside where it is.
void seek_jumps(const FitHand& hand, std::span<const FitFrame* const> frames,
                const TriangleMesh& object, const JointFitOptions& options,
                HandEstimate& estimate) {
  if (frames.size() < 3) return;
  const std::vector<Rigid3d> poses = estimate.world_from_hand;
  parallel_for(frames.size(), options.threads, [&](std::size_t f) {
    const Rigid3d expected = expected_pose(poses, f);
    if (expected.rotation.angularDistance(poses[f].rotation) < kJumpAngle &&
        (expected.translation - poses[f].translation).norm() < kJumpLength * hand.scale) {
      return;
    }
    const FrameFit there = fit_known_from_afar(hand, *frames[f], {expected, estimate.angles},
                                               object, options.with_object);
    const FrameFit here =
        fit_known(hand, *frames[f], {poses[f], estimate.angles}, object, options.with_object);
    if (there.report.energy < here.report.energy) {
      estimate.world_from_hand[f] = there.pose.world_from_hand;
    }
  });
}

// Lets all frames settle by a schedule and seeks suspects anew; with `reseats` fingers are tried in
// other places as well.
SolverReport settle(const FitHand& hand, std::span<const FitFrame* const> frames,
                    const FitSchedule& schedule, bool reseats, const JointFitOptions& options,
                    std::vector<bool>& settled, HandEstimate& estimate) {
  SolverReport report = minimise(hand, frames, schedule, options.threads, estimate);
  int iterations = report.iterations;
  if (seek_suspects(hand, frames, report.frame_energies, options, settled, estimate)) {
    report = minimise(hand, frames, schedule, options.threads, estimate);
    iterations += report.iterations;
  }
  if (reseats) {
    if (const std::optional<SolverReport> better =
            reseat_digits(hand, frames, schedule, options.threads, estimate)) {
      report = *better;
      iterations += report.iterations;
    }
  }
  report.iterations = iterations;
  return report;
}

// The last stage of all: where those before it end, jumps of their energy decide. Hulls, which say
// little beside the outlines, are not asked: their triangles change with the slightest rounding.
FitStage settling_stage() {
  FitStage stage;
  stage.border = BorderTermOptions{.weight = 30.0};  // as the contours have it
  stage.most_iterations = 0;
  stage.settling_steps = 20;
  return stage;
}

// Leaves views out that contradict the others; true where there were any.
bool leave_out_contradictions(const FitHand& hand, const TriangleMesh& object,
                              const JointFitOptions& options, AgreeingFrames& agreeing,
                              HandEstimate& estimate) {
  std::vector<HandPose> poses = estimate.poses();
  const bool is_any = agreeing.leave_out_contradictions(
      hand, poses, object, {options.with_object, options.hull}, options.threads);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    estimate.world_from_hand[f] = poses[f].world_from_hand;
  }
  return is_any;
}

}  // namespace

JointFit fit_jointly(const FitHand& hand, AgreeingFrames& agreeing, HandEstimate start,
                     const JointFitOptions& options, const Observer& observer) {
  JointFit fit;
  fit.estimate = std::move(start);
  HandEstimate& estimate = fit.estimate;
  const auto rounds = static_cast<std::size_t>(options.object_rounds) + 1;
  const std::vector<const FitFrame*>& frames = agreeing.frames();
  std::vector<FitFrame> surrounded;
  std::vector<bool> settled(frames.size(), false);
  int iterations = 0;
  // Draws what is known to stand about the hand anew and lets all settle among it.
  const auto settle_among = [&](const FitSchedule& schedule, bool reseats) {
    surrounded = with_surroundings(hand, frames, estimate, fit.object.surface, options.threads);
    fit.report =
        settle(hand, pointers_to(surrounded), schedule, reseats, options, settled, estimate);
    iterations += fit.report.iterations;
  };
  observer.progress("all frames", 0, rounds);
  settle_among(options.all_frames, rounds > 1);
  for (std::size_t round = 1; round < rounds; ++round) {
    observer.progress("all frames", round, rounds);
    surrounded = with_surroundings(hand, frames, estimate, {}, options.threads);
    fit.object = find_hidden_object(hand, pointers_to(surrounded), estimate, options.object,
                                    options.threads);
    seek_jumps(hand, frames, fit.object.surface, options, estimate);
    const bool is_any = !fit.object.surface.triangles.empty();
    const FitSchedule& schedule = is_any ? options.with_object : options.all_frames;
    settle_among(schedule, true);
    if (leave_out_contradictions(hand, fit.object.surface, options, agreeing, estimate)) {
      settled.assign(frames.size(), false);
      settle_among(schedule, false);
    } else if (!is_any && round > 1) {
      break;
    }
  }
  if (rounds > 1) {
    iterations +=
        minimise(hand, pointers_to(surrounded), settling_stage(), options.threads, estimate)
            .iterations;
  }
  observer.progress("all frames", rounds, rounds);
  fit.report.iterations = iterations;
  return fit;
}

}  // namespace tegata
