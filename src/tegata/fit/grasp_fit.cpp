// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/grasp_fit.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/known_grasp.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// A frame that was followed in a few steps whose energy is so many times the median of those before
// is sought farther.
constexpr double kFollowedEnergyRatio = 1.2;
// A tracked frame whose energy is so many times the median of those before may be lost.
constexpr double kLostEnergyRatio = 2.0;
// With more of the seen hand beside the fitted one [m] the start was probably wrong.
constexpr double kLikelyUncovered = 4e-4;
// From the normal equations' deviations to true ones: neighbouring residuals are not independent.
// Chosen with hands of known shape on 15 simulated takes (three grasps, three infrared cameras, ten
// frames): 64 % of the true angles lie within one. A hand of another shape than the
// fitted one is farther off than this says.
constexpr double kDeviationScale = 0.8;
// How far the angles may leave what is known of them [rad], stage by stage: a turning hand is first
// followed nearly stiff, as nothing else moves the fingers' surfaces as far.
constexpr double kFixedDeviations[] = {0.03, 0.06, 0.1, 0.15};
constexpr double kFreeDeviations[] = {0.1, 0.15, 0.2, 0.3};
// Of a frame's angles from those of a soft grasp [rad]: real grasps drift by 4 to 8 degrees.
constexpr double kSoftDeviations[] = {0.1, 0.1, 0.1, 0.1};

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
  const AngleDeviations deviations = options.grasp == GraspConstraint::free
                                         ? AngleDeviations(kFreeDeviations)
                                         : AngleDeviations(kFixedDeviations);
  const auto fit_by = [&](std::vector<FitSchedule> schedules) {
    return fit_frame_from_best(hand, frame, starts, starts.size(),
                               holding(std::move(schedules), last.angles, deviations),
                               options.threads);
  };
  const double usual = median(energies);
  const FrameFit followed = fit_by({follow_schedule()});
  if (followed.report.energy <= kFollowedEnergyRatio * usual) return followed;
  const FrameFit tracked = fit_by(options.joint.frame);
  if (tracked.report.energy <= kLostEnergyRatio * usual) return tracked;
  const FrameFit found = fit_frame_from_nothing(
      hand, frame, {last.angles}, holding(options.joint.frame, last.angles, deviations),
      options.threads);
  return found.report.energy < tracked.report.energy ? found : tracked;
}

// The fits of all frames one after the other.
std::vector<FrameFit> fit_in_order(const FitHand& hand, std::span<const FitFrame* const> frames,
                                   const GraspFitOptions& options, const Observer& observer) {
  std::vector<FrameFit> fits;
  std::vector<double> energies;
  for (const FitFrame* frame : frames) {
    observer.progress("frames", fits.size(), frames.size());
    fits.push_back(fits.empty() ? fit_frame_from_nothing(hand, *frame, typical_angles(),
                                                         options.joint.frame, options.threads)
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

// Some of the frames, by position in all.
struct ChosenFrames {
  ChosenFrames(std::span<const FitFrame* const> all, std::vector<std::size_t> positions)
      : chosen(std::move(positions)), agreeing(pointers(all, chosen)) {}

  static std::vector<const FitFrame*> pointers(std::span<const FitFrame* const> all,
                                               const std::vector<std::size_t>& chosen) {
    std::vector<const FitFrame*> some;
    for (const std::size_t f : chosen) some.push_back(all[f]);
    return some;
  }
  // The frames' poses and what was left out of them, into those of all.
  void keep(const std::vector<HandPose>& poses, GraspFit& grasp) const {
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      grasp.poses[chosen[i]] = poses[i];
      grasp.left_out[chosen[i]] = agreeing.left_out()[i];
    }
  }

  std::vector<std::size_t> chosen;
  AgreeingFrames agreeing;
};

std::vector<std::size_t> others_than(const std::vector<std::size_t>& chosen, std::size_t count) {
  std::vector<std::size_t> others;
  for (std::size_t f = 0; f < count; ++f) {
    if (!std::binary_search(chosen.begin(), chosen.end(), f)) others.push_back(f);
  }
  return others;
}

// One set of angles from frames spread over all, and with it the poses of the others.
void fit_one_grasp(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const std::vector<FrameFit>& fits, const GraspFitOptions& options,
                   const Observer& observer, GraspFit& grasp) {
  JointFitOptions joint_options = options.joint;
  joint_options.threads = options.threads;
  ChosenFrames joint_frames(frames, spread(frames.size(), options.most_joint_frames));
  std::vector<FrameFit> joint_fits;
  for (const std::size_t f : joint_frames.chosen) joint_fits.push_back(fits[f]);
  const JointFit joint = fit_jointly(hand, joint_frames.agreeing, median_estimate(joint_fits),
                                     joint_options, observer);
  grasp.iterations = joint.report.iterations;
  grasp.termination = joint.report.termination;
  grasp.standard_deviations = standard_deviations(joint.report);
  grasp.angles = joint.estimate.angles;
  grasp.object = joint.object;
  joint_frames.keep(joint.estimate.poses(), grasp);

  const TriangleMesh& object = joint.object.surface;
  const auto fit_each = [&](const ChosenFrames& some, AngleDeviations deviations,
                            std::vector<HandPose>& poses) {
    parallel_for(poses.size(), options.threads, [&](std::size_t i) {
      poses[i] = fit_known(hand, *some.agreeing.frames()[i], poses[i], object,
                           joint_options.with_object, deviations)
                     .pose;
    });
  };
  ChosenFrames other_frames(frames, others_than(joint_frames.chosen, frames.size()));
  std::vector<HandPose> others;
  for (const std::size_t f : other_frames.chosen) {
    others.push_back({fits[f].pose.world_from_hand, grasp.angles});
  }
  fit_each(other_frames, kKnownDeviations, others);
  for (HandPose& pose : others) pose.angles = grasp.angles;
  other_frames.agreeing.leave_out_contradictions(
      hand, others, object, {joint_options.with_object, joint_options.hull}, options.threads);
  other_frames.keep(others, grasp);
  if (options.grasp != GraspConstraint::soft) return;
  for (const ChosenFrames* some : {&joint_frames, &other_frames}) {
    std::vector<HandPose> poses;
    for (const std::size_t f : some->chosen) poses.push_back(grasp.poses[f]);
    fit_each(*some, kSoftDeviations, poses);
    some->keep(poses, grasp);
  }
}

// Every frame on its own: the mean of the angles and their spread stand for the grasp.
void keep_frames_free(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const std::vector<FrameFit>& fits, const GraspFitOptions& options,
                      GraspFit& grasp) {
  for (std::size_t f = 0; f < fits.size(); ++f) grasp.poses[f] = fits[f].pose;
  AgreeingFrames agreeing(frames);
  agreeing.leave_out_contradictions(
      hand, grasp.poses, {}, {options.joint.with_object, options.joint.hull}, options.threads);
  grasp.left_out = agreeing.left_out();
  const double count = static_cast<double>(fits.size());
  grasp.angles.setZero();
  for (const FrameFit& fit : fits) {
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

// From the first frame to the last.
GraspFit fit_forwards(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const GraspFitOptions& options, const Observer& observer) {
  GraspFit grasp;
  grasp.poses.resize(frames.size());
  grasp.left_out.resize(frames.size());
  const Stopwatch frame_watch;
  const std::vector<FrameFit> fits = fit_in_order(hand, frames, options, observer);
  grasp.frame_seconds = frame_watch.seconds();
  const Stopwatch grasp_watch;
  if (options.grasp == GraspConstraint::free) {
    keep_frames_free(hand, frames, fits, options, grasp);
  } else {
    fit_one_grasp(hand, frames, fits, options, observer, grasp);
  }
  grasp.all_frames_seconds = grasp_watch.seconds();
  return grasp;
}

GraspFit fit_backwards(const FitHand& hand, std::span<const FitFrame* const> frames,
                       const GraspFitOptions& options, const Observer& observer) {
  const std::vector<const FitFrame*> reversed(frames.rbegin(), frames.rend());
  GraspFit grasp = fit_forwards(hand, reversed, options, observer);
  std::reverse(grasp.poses.begin(), grasp.poses.end());
  std::reverse(grasp.left_out.begin(), grasp.left_out.end());
  return grasp;
}

// How much of the seen hand lies beside the fitted one, in the view of each frame where that is
// most [m]: the mean over the frames.
double uncovered_by(const FitHand& hand, std::span<const FitFrame* const> frames,
                    const GraspFit& grasp, int threads) {
  std::vector<double> most(frames.size(), 0.0);
  parallel_for(frames.size(), threads, [&](std::size_t f) {
    for (const double distance : uncovered_distances(hand, *frames[f], grasp.poses[f])) {
      most[f] = std::max(most[f], distance);
    }
  });
  return std::accumulate(most.begin(), most.end(), 0.0) / static_cast<double>(most.size());
}

}  // namespace

GraspFit fit_grasp(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const GraspFitOptions& options, const Observer& observer) {
  if (frames.empty()) throw Error("grasp fit: got no frame, expected at least one");
  for (const FitFrame* frame : frames) {
    if (!frame->hull) throw Error("grasp fit: got a frame without a hull, expected one for each");
  }
  GraspFit grasp = fit_forwards(hand, frames, options, observer);
  if (!options.seeks_again || frames.size() == 1 || frames.front()->landmarks) return grasp;
  const double uncovered = uncovered_by(hand, frames, grasp, options.threads);
  if (uncovered <= kLikelyUncovered * hand.scale) return grasp;
  GraspFit other = fit_backwards(hand, frames, options, observer);
  const double frame_seconds = grasp.frame_seconds + other.frame_seconds;
  const double all_frames_seconds = grasp.all_frames_seconds + other.all_frames_seconds;
  if (uncovered_by(hand, frames, other, options.threads) < uncovered) grasp = std::move(other);
  grasp.frame_seconds = frame_seconds;
  grasp.all_frames_seconds = all_frames_seconds;
  return grasp;
}

}  // namespace tegata
