// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/grasp_fit.h"

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"

namespace tegata {
namespace {

// How many of the starts are followed to the end.
constexpr std::size_t kKeptStarts = 4;

std::vector<HandPose> first_starts(const FitHand& hand, const TriangleMesh& hull,
                                   const std::optional<StartLandmarks>& landmarks,
                                   int orientations) {
  const Skeleton& skeleton = hand.model->skeleton;
  const std::vector<Rigid3d> poses =
      landmarks ? std::vector<Rigid3d>{pose_from_landmarks(skeleton, *landmarks)}
                : poses_around(skeleton, hull, orientations);
  std::vector<HandPose> starts;
  for (const Rigid3d& pose : poses) {
    for (const JointAngles& angles : typical_angles()) starts.push_back({pose, angles});
  }
  return starts;
}

// Where the hand would be if it went on as it went from the frame before the last to the last.
Rigid3d extrapolated(const Rigid3d& before, const Rigid3d& last) {
  const Eigen::Quaterniond turn = last.rotation * before.rotation.conjugate();
  return {(turn * last.rotation).normalized(), 2.0 * last.translation - before.translation};
}

// The fits of all frames one after the other, each started from the one before.
std::vector<FrameFit> fit_in_order(const FitHand& hand, std::span<const FitFrame* const> frames,
                                   const std::vector<HandPose>& starts,
                                   const GraspFitOptions& options, const Observer& observer) {
  std::vector<FrameFit> fits;
  for (const FitFrame* frame : frames) {
    observer.progress("frames", fits.size(), frames.size());
    if (fits.empty()) {
      fits.push_back(
          fit_frame_from_best(hand, *frame, starts, kKeptStarts, options.frame, options.threads));
      continue;
    }
    const HandPose& last = fits.back().pose;
    std::vector<HandPose> next = {last};
    if (fits.size() > 1) {
      const HandPose& before = fits[fits.size() - 2].pose;
      next.push_back({extrapolated(before.world_from_hand, last.world_from_hand), last.angles});
    }
    FitSchedule schedule = options.frame;
    for (FitStage& stage : schedule.stages) stage.prior.previous = last.angles;
    fits.push_back(fit_frame_from_best(hand, *frame, next, next.size(), schedule, options.threads));
  }
  observer.progress("frames", frames.size(), frames.size());
  return fits;
}

JointAngles median_angles(const std::vector<FrameFit>& fits) {
  JointAngles median;
  std::vector<double> values(fits.size());
  for (int k = 0; k < kAngleCount; ++k) {
    std::transform(fits.begin(), fits.end(), values.begin(),
                   [k](const FrameFit& fit) { return fit.pose.angles[k]; });
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[k] = *middle;
  }
  return median;
}

JointAngles standard_deviations(const SolverReport& report) {
  return report.angle_covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

void fit_all_frames(const FitHand& hand, std::span<const FitFrame* const> frames,
                    const std::vector<FrameFit>& fits, const GraspFitOptions& options,
                    GraspFit& grasp) {
  HandEstimate estimate;
  estimate.angles = median_angles(fits);
  for (const FrameFit& fit : fits) {
    estimate.world_from_hand.push_back(fit.pose.world_from_hand);
  }
  for (const FitStage& stage : options.all_frames.stages) {
    const SolverReport report = minimise(hand, frames, stage, options.threads, estimate);
    grasp.iterations += report.iterations;
    grasp.termination = report.termination;
    grasp.standard_deviations = standard_deviations(report);
  }
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
                   const TriangleMesh& first_hull, const std::optional<StartLandmarks>& landmarks,
                   const GraspFitOptions& options, const Observer& observer) {
  if (frames.empty()) throw Error("grasp fit: got no frame, expected at least one");
  for (const FitFrame* frame : frames) {
    if (!frame->hull) throw Error("grasp fit: got a frame without a hull, expected one for each");
  }
  GraspFit grasp;
  const Stopwatch frame_watch;
  const std::vector<FrameFit> fits = fit_in_order(
      hand, frames, first_starts(hand, first_hull, landmarks, options.start_orientations), options,
      observer);
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
