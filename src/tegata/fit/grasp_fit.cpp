// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/grasp_fit.h"

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// A frame that was followed in a few steps whose energy is so many times the median of those before
// is sought farther.
constexpr double kFollowedEnergyRatio = 1.2;
// A tracked frame whose energy is so many times the median of those before may be lost.
constexpr double kLostEnergyRatio = 2.0;
// From the normal equations' deviations to true ones: neighbouring residuals are not independent.
// Chosen with hands of known shape on 15 simulated takes (three grasps, three infrared cameras, ten
// frames): with 0.6, 55 % of the true angles lay within one. A hand of another shape than the
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

// One set of angles from frames spread over all, and with it the poses of the others.
void fit_one_grasp(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const std::vector<FrameFit>& fits, const GraspFitOptions& options,
                   const Observer& observer, GraspFit& grasp) {
  const std::vector<std::size_t> chosen = spread(frames.size(), options.most_joint_frames);
  std::vector<const FitFrame*> joint_frames;
  std::vector<FrameFit> joint_fits;
  for (const std::size_t f : chosen) {
    joint_frames.push_back(frames[f]);
    joint_fits.push_back(fits[f]);
  }
  JointFitOptions joint_options = options.joint;
  joint_options.threads = options.threads;
  const JointFit joint =
      fit_jointly(hand, joint_frames, median_estimate(joint_fits), joint_options, observer);
  grasp.iterations = joint.report.iterations;
  grasp.termination = joint.report.termination;
  grasp.standard_deviations = standard_deviations(joint.report);
  grasp.angles = joint.estimate.angles;
  grasp.object = joint.object;
  grasp.poses.resize(frames.size());
  parallel_for(frames.size(), options.threads, [&](std::size_t f) {
    const auto place = std::lower_bound(chosen.begin(), chosen.end(), f);
    const bool is_joint = place != chosen.end() && *place == f;
    grasp.poses[f] = is_joint
                         ? joint.estimate.pose(static_cast<std::size_t>(place - chosen.begin()))
                         : HandPose{fits[f].pose.world_from_hand, grasp.angles};
    const auto fit_with = [&](AngleDeviations deviations) {
      return fit_known(hand, *frames[f], grasp.poses[f], joint.object, joint_options, deviations)
          .pose;
    };
    if (!is_joint) {
      grasp.poses[f] = {fit_with(kKnownDeviations).world_from_hand, grasp.angles};
    }
    if (options.grasp == GraspConstraint::soft) grasp.poses[f] = fit_with(kSoftDeviations);
  });
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
    fit_one_grasp(hand, frames, fits, options, observer, grasp);
  }
  grasp.all_frames_seconds = grasp_watch.seconds();
  return grasp;
}

}  // namespace tegata
