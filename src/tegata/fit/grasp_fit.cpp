// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/grasp_fit.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/known_grasp.h"
#include "tegata/fit/lost_frames.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// A frame that was followed in a few steps whose energy is so many times the median of those before
// is sought farther.
constexpr double kFollowedEnergyRatio = 1.2;
// A tracked frame whose energy is so many times the median of those before may be lost.
constexpr double kLostEnergyRatio = 2.0;
// With more of the seen hand beside the fitted one [m] a beginning may be wrong; with more than
// this and so many times what it left itself in all frames it probably was.
constexpr double kLikelyUncovered = 4e-4, kWrongBeginningRatio = 2.0;
// From the normal equations' deviations to true ones: neighbouring residuals are not independent.
// Chosen with hands of known shape on the 45 takes of `tegata experiment accuracy`
// (docs/accuracy.md). A hand of another shape than the fitted one is farther off than this says.
constexpr double kDeviationScale = 0.53;
// How far the angles may leave what is known of them [rad], stage by stage: a turning hand is first
// followed nearly stiff, as nothing else moves the fingers' surfaces as far.
constexpr double kFixedDeviations[] = {0.03, 0.06, 0.1, 0.15};
constexpr double kFreeDeviations[] = {0.1, 0.15, 0.2, 0.3};
// Of a frame's angles from those of a soft grasp [rad]: real grasps drift by 4 to 8 degrees.
constexpr double kSoftDeviations[] = {0.1, 0.1, 0.1, 0.1};

// A frame's fit, and how much of the seen hand it leaves uncovered.
struct MeasuredFit {
  MeasuredFit(const FitHand& hand, const FitFrame& frame, FrameFit measured)
      : fit(std::move(measured)), uncovered(uncovered_in_most(hand, frame, fit.pose)) {}

  FrameFit fit;
  double uncovered;  // [m]
};

std::shared_ptr<const FitFrame> frame_with_hull(const FrameSource& frames, std::size_t f) {
  std::shared_ptr<const FitFrame> frame = frames.frame(f);
  if (!frame->hull) throw Error("grasp fit: got a frame without a hull, expected one for each");
  return frame;
}

// A frame that was sought from nothing: the others may be found from it on.
struct Beginning {
  std::size_t frame;
  MeasuredFit measured;
};

Beginning begin_at(const FitHand& hand, const FrameSource& frames, std::size_t f,
                   const GraspFitOptions& options) {
  const std::shared_ptr<const FitFrame> frame = frame_with_hull(frames, f);
  return {f,
          {hand, *frame,
           fit_frame_from_nothing(hand, *frame, typical_angles(), options.joint.frame,
                                  options.threads)}};
}

// Where the hand was found from nothing, the most likely first: in the first frame, and where that
// leaves much of the seen hand uncovered in the last and in the middle one as well.
std::vector<Beginning> find_beginnings(const FitHand& hand, const FrameSource& frames,
                                       const GraspFitOptions& options, const Observer& observer) {
  observer.progress("frames", 0, frames.size());
  std::vector<Beginning> found = {begin_at(hand, frames, 0, options)};
  if (frames.frame(0)->landmarks) return found;
  for (const std::size_t f : {frames.size() - 1, frames.size() / 2}) {
    const Beginning& last = found.back();
    if (last.frame == f || last.measured.uncovered <= kLikelyUncovered * hand.scale) break;
    found.push_back(begin_at(hand, frames, f, options));
  }
  std::stable_sort(found.begin(), found.end(), [](const Beginning& a, const Beginning& b) {
    return a.measured.uncovered < b.measured.uncovered;
  });
  return found;
}

// The frames that were followed so far.
class FollowedFrames {
 public:
  FollowedFrames(std::size_t count, const Beginning& beginning) : fits_(count) {
    set(beginning.frame, beginning.measured);
  }
  void set(std::size_t f, const MeasuredFit& measured) {
    fits_[f] = measured.fit;
    energies_.push_back(measured.fit.report.energy);
    uncovered_.push_back(measured.uncovered);
  }
  // Whether a fit has at most so many times the usual energy, and leaves no more uncovered than
  // usual.
  bool is_usual(const FitHand& hand, const MeasuredFit& measured, double energy_ratio) const {
    return measured.fit.report.energy <= energy_ratio * median(energies_) &&
           measured.uncovered <= most_uncovered(hand, uncovered_);
  }
  // The frames `step` before f (1) or after it (-1): the next one first.
  std::vector<HandPose> neighbours(std::size_t f, int step) const {
    std::vector<HandPose> poses;
    for (int i = 1; i <= 2; ++i) {
      const auto at = static_cast<std::size_t>(static_cast<int>(f) - i * step);
      if (at >= fits_.size() || !fits_[at]) break;
      poses.push_back(fits_[at]->pose);
    }
    return poses;
  }
  std::vector<FrameFit> fits() const {
    std::vector<FrameFit> all;
    for (const std::optional<FrameFit>& fit : fits_) all.push_back(*fit);
    return all;
  }

 private:
  std::vector<std::optional<FrameFit>> fits_;
  std::vector<double> energies_, uncovered_;
};

// A frame beside others, `step` beyond the last one: from where the hand was or would be and, where
// that fits far worse than the frames so far did, from nothing: the hand may have been lost.
MeasuredFit fit_next(const FitHand& hand, const FitFrame& frame, const FollowedFrames& followed,
                     std::size_t f, int step, const GraspFitOptions& options) {
  const std::vector<HandPose> before = followed.neighbours(f, step);
  const HandPose& last = before.front();
  std::vector<HandPose> starts = {last};
  if (before.size() > 1) {
    starts.push_back({extrapolated(before[1].world_from_hand, last.world_from_hand), last.angles});
  }
  const AngleDeviations deviations = options.grasp == GraspConstraint::free
                                         ? AngleDeviations(kFreeDeviations)
                                         : AngleDeviations(kFixedDeviations);
  const auto fit_by = [&](std::vector<FitSchedule> schedules) {
    return MeasuredFit(hand, frame,
                       fit_frame_from_best(hand, frame, starts, starts.size(),
                                           holding(std::move(schedules), last.angles, deviations),
                                           options.threads));
  };
  const MeasuredFit near = fit_by({follow_schedule()});
  if (followed.is_usual(hand, near, kFollowedEnergyRatio)) return near;
  const MeasuredFit tracked = fit_by(options.joint.frame);
  if (followed.is_usual(hand, tracked, kLostEnergyRatio)) return tracked;
  const MeasuredFit found(
      hand, frame,
      fit_frame_from_nothing(hand, frame, {last.angles},
                             holding(options.joint.frame, last.angles, deviations),
                             options.threads));
  return found.fit.report.energy < tracked.fit.report.energy ? found : tracked;
}

// The fits of all frames: from the beginning on to the last one, then back to the first.
std::vector<FrameFit> fit_outwards(const FitHand& hand, const FrameSource& frames,
                                   const Beginning& beginning, const GraspFitOptions& options,
                                   const Observer& observer) {
  FollowedFrames followed(frames.size(), beginning);
  std::size_t done = 1;
  const auto follow = [&](std::size_t f, int step) {
    observer.progress("frames", done++, frames.size());
    followed.set(f, fit_next(hand, *frame_with_hull(frames, f), followed, f, step, options));
  };
  for (std::size_t f = beginning.frame + 1; f < frames.size(); ++f) follow(f, 1);
  for (std::size_t f = beginning.frame; f-- > 0;) follow(f, -1);
  observer.progress("frames", frames.size(), frames.size());
  return followed.fits();
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
  ChosenFrames(const FrameSource& all, std::vector<std::size_t> positions, int threads)
      : chosen(std::move(positions)), kept(made(all, chosen, threads)), agreeing(pointers(kept)) {}

  using Kept = std::vector<std::shared_ptr<const FitFrame>>;
  static Kept made(const FrameSource& all, const std::vector<std::size_t>& chosen, int threads) {
    Kept some(chosen.size());
    parallel_for(some.size(), threads, [&](std::size_t i) { some[i] = all.frame(chosen[i]); });
    return some;
  }
  static std::vector<const FitFrame*> pointers(const Kept& kept) {
    std::vector<const FitFrame*> some;
    for (const auto& frame : kept) some.push_back(frame.get());
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
  Kept kept;
  AgreeingFrames agreeing;
};

// Calls visit(some) for a few frames after the other, until all of `positions` were there.
template <typename Visit>
void visit_few_by_few(const FrameSource& frames, const std::vector<std::size_t>& positions,
                      const GraspFitOptions& options, const Visit& visit) {
  const std::size_t few = options.most_joint_frames;
  for (std::size_t first = 0; first < positions.size(); first += few) {
    const std::size_t count = std::min(few, positions.size() - first);
    const auto begin = positions.begin() + static_cast<std::ptrdiff_t>(first);
    ChosenFrames some(frames, {begin, begin + static_cast<std::ptrdiff_t>(count)}, options.threads);
    visit(some);
  }
}

std::vector<std::size_t> others_than(const std::vector<std::size_t>& chosen, std::size_t count) {
  std::vector<std::size_t> others;
  for (std::size_t f = 0; f < count; ++f) {
    if (!std::binary_search(chosen.begin(), chosen.end(), f)) others.push_back(f);
  }
  return others;
}

// One set of angles from frames spread over all, and with it the poses of the others.
void fit_one_grasp(const FitHand& hand, const FrameSource& frames,
                   const std::vector<FrameFit>& fits, const GraspFitOptions& options,
                   const Observer& observer, GraspFit& grasp) {
  JointFitOptions joint_options = options.joint;
  joint_options.threads = options.threads;
  const std::vector<std::size_t> chosen = spread(frames.size(), options.most_joint_frames);
  std::vector<FrameFit> joint_fits;
  for (const std::size_t f : chosen) joint_fits.push_back(fits[f]);
  std::optional<ChosenFrames> joint_frames(std::in_place, frames, chosen, options.threads);
  const JointFit joint = fit_jointly(hand, joint_frames->agreeing, median_estimate(joint_fits),
                                     joint_options, observer);
  grasp.iterations = joint.report.iterations;
  grasp.termination = joint.report.termination;
  grasp.standard_deviations = standard_deviations(joint.report);
  grasp.angles = joint.estimate.angles;
  grasp.object = joint.object;
  const TriangleMesh& object = joint.object.surface;
  const auto fit_each = [&](const ChosenFrames& some, AngleDeviations deviations,
                            std::vector<HandPose>& poses) {
    parallel_for(poses.size(), options.threads, [&](std::size_t i) {
      poses[i] = fit_known(hand, *some.agreeing.frames()[i], poses[i], object,
                           joint_options.with_object, deviations)
                     .pose;
    });
  };
  const auto keep = [&](const ChosenFrames& some, std::vector<HandPose> poses) {
    if (options.grasp == GraspConstraint::soft) fit_each(some, kSoftDeviations, poses);
    some.keep(poses, grasp);
  };
  keep(*joint_frames, joint.estimate.poses());
  joint_frames.reset();
  const auto fit_others = [&](ChosenFrames& some) {
    std::vector<HandPose> poses;
    for (const std::size_t f : some.chosen) {
      poses.push_back({fits[f].pose.world_from_hand, grasp.angles});
    }
    fit_each(some, kKnownDeviations, poses);
    for (HandPose& pose : poses) pose.angles = grasp.angles;
    some.agreeing.leave_out_contradictions(
        hand, poses, object, {joint_options.with_object, joint_options.hull}, options.threads);
    keep(some, std::move(poses));
  };
  visit_few_by_few(frames, others_than(chosen, frames.size()), options, fit_others);
}

// Every frame on its own: the mean of the angles and their spread stand for the grasp.
void keep_frames_free(const FitHand& hand, const FrameSource& frames,
                      const std::vector<FrameFit>& fits, const GraspFitOptions& options,
                      GraspFit& grasp) {
  visit_few_by_few(frames, others_than({}, frames.size()), options, [&](ChosenFrames& some) {
    std::vector<HandPose> poses;
    for (const std::size_t f : some.chosen) poses.push_back(fits[f].pose);
    some.agreeing.leave_out_contradictions(
        hand, poses, {}, {options.joint.with_object, options.joint.hull}, options.threads);
    some.keep(poses, grasp);
  });
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

// All frames from a beginning on.
GraspFit fit_from(const FitHand& hand, const FrameSource& frames, const Beginning& beginning,
                  const GraspFitOptions& options, const Observer& observer) {
  GraspFit grasp;
  grasp.poses.resize(frames.size());
  grasp.left_out.resize(frames.size());
  grasp.start = {beginning.frame, beginning.measured.fit.lead};
  const Stopwatch frame_watch;
  const std::vector<FrameFit> fits = fit_outwards(hand, frames, beginning, options, observer);
  grasp.frame_seconds = frame_watch.seconds();
  const Stopwatch grasp_watch;
  if (options.grasp == GraspConstraint::free) {
    keep_frames_free(hand, frames, fits, options, grasp);
  } else {
    fit_one_grasp(hand, frames, fits, options, observer, grasp);
    find_lost_frames(hand, frames, {grasp.angles, grasp.object.surface, options.joint.with_object},
                     options.threads, grasp.poses, grasp.left_out);
  }
  grasp.all_frames_seconds = grasp_watch.seconds();
  return grasp;
}

// How much of the seen hand lies beside the fitted one in the view of each frame where that is most
// [m]: the mean over frames spread over all.
double uncovered_by(const FitHand& hand, const FrameSource& frames, const GraspFit& grasp,
                    const GraspFitOptions& options) {
  const std::vector<std::size_t> asked = spread(frames.size(), options.most_joint_frames);
  std::vector<double> uncovered(asked.size(), 0.0);
  parallel_for(asked.size(), options.threads, [&](std::size_t i) {
    const std::shared_ptr<const FitFrame> frame = frames.frame(asked[i]);
    const HandPose& pose = grasp.poses[asked[i]];
    uncovered[i] = uncovered_in_most(hand, *frame, pose);
    for (const double distance : uncovered_distances(hand, *frame, pose)) {
      uncovered[i] = std::max(uncovered[i], distance);
    }
  });
  return std::accumulate(uncovered.begin(), uncovered.end(), 0.0) /
         static_cast<double>(uncovered.size());
}

}  // namespace

GraspFit fit_grasp(const FitHand& hand, const FrameSource& frames, const GraspFitOptions& options,
                   const Observer& observer) {
  if (frames.size() == 0) throw Error("grasp fit: got no frame, expected at least one");
  if (options.most_joint_frames == 0) {
    throw Error("grasp fit: got no frames for the angles, expected at least one");
  }
  const Stopwatch watch;
  std::vector<Beginning> beginnings = find_beginnings(hand, frames, options, observer);
  const double beginning_seconds = watch.seconds();
  GraspFit grasp = fit_from(hand, frames, beginnings[0], options, observer);
  grasp.frame_seconds += beginning_seconds;
  if (!options.seeks_again || frames.size() == 1 || frames.frame(0)->landmarks) return grasp;
  double uncovered = uncovered_by(hand, frames, grasp, options);
  const double usual = std::max(kLikelyUncovered * hand.scale,
                                kWrongBeginningRatio * beginnings[0].measured.uncovered);
  if (uncovered <= usual) return grasp;
  if (beginnings.size() == 1) {
    beginnings.push_back(begin_at(hand, frames, frames.size() - 1, options));
  }
  for (std::size_t b = 1; b < beginnings.size() && uncovered > usual; ++b) {
    GraspFit other = fit_from(hand, frames, beginnings[b], options, observer);
    const double frame_seconds = grasp.frame_seconds + other.frame_seconds;
    const double all_frames_seconds = grasp.all_frames_seconds + other.all_frames_seconds;
    const double by_other = uncovered_by(hand, frames, other, options);
    if (by_other < uncovered) {
      grasp = std::move(other);
      uncovered = by_other;
    }
    grasp.frame_seconds = frame_seconds;
    grasp.all_frames_seconds = all_frames_seconds;
  }
  return grasp;
}

}  // namespace tegata
