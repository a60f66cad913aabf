// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/size_hand.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tegata/base/stopwatch.h"
#include "tegata/fit/frame_fit.h"
#include "tegata/hand/scaled_hand.h"

namespace tegata {
namespace {

// Tried on so many frames of the first take: adults' hands are 0.85 to 1.15 of the mean one, and a
// fit finds a scale that is 0.1 away.
constexpr double kStartScales[] = {1.0, 0.9, 1.1};
constexpr std::size_t kStartFrames = 3;
// A start that is nearer to a scale found before is not tried.
constexpr double kSameStart = 0.05;
constexpr int kMostRounds = 3;
// A round that changes the scale by less was the last.
constexpr double kScaleTolerance = 0.015;

// A take's grasps are told by so many of its frames.
constexpr std::size_t kMostFrames = 40;

// The first frames of a take.
class FirstFrames final : public FrameSource {
 public:
  FirstFrames(const FrameSource& frames, std::size_t most)
      : frames_(frames), count_(std::min(most, frames.size())) {}
  std::size_t size() const override { return count_; }
  std::shared_ptr<const FitFrame> frame(std::size_t i) const override { return frames_.frame(i); }

 private:
  const FrameSource& frames_;
  std::size_t count_;
};

// Fits frames of some takes, then the scale with them.
ScaleFit fit_round(const HandModel& hand, double scale, std::span<const FrameSource* const> takes,
                   const GraspFitOptions& options, const Observer& observer) {
  const HandModel current = scaled(hand, scale);
  const FitHand fit_hand(current);
  KeptGrasps kept;
  for (const FrameSource* frames : takes) {
    kept.add(fit_grasp(fit_hand, *frames, options, observer), *frames, options.grasp);
  }
  ShapeFitOptions shape_options;
  shape_options.threads = options.threads;
  return fit_scale(hand, scale, kept.grasps, shape_options);
}

double start_scale(const HandModel& hand, const FrameSource& frames, const GraspFitOptions& options,
                   const Observer& observer) {
  const FirstFrames first(frames, kStartFrames);
  const FrameSource* const one[] = {&first};
  std::vector<ScaleFit> fits;
  for (const double start : kStartScales) {
    observer.progress("sizes", fits.size(), std::size(kStartScales));
    if (std::any_of(fits.begin(), fits.end(), [&](const ScaleFit& fit) {
          return std::abs(fit.scale - start) < kSameStart;
        })) {
      continue;
    }
    fits.push_back(fit_round(hand, start, one, options, Observer{}));
  }
  observer.progress("sizes", std::size(kStartScales), std::size(kStartScales));
  return std::min_element(fits.begin(), fits.end(),
                          [](const ScaleFit& a, const ScaleFit& b) { return a.energy < b.energy; })
      ->scale;
}

}  // namespace

void KeptGrasps::add(const GraspFit& fit, const FrameSource& source, GraspConstraint constraint) {
  const std::vector<std::size_t> chosen = spread(source.size(), kMostFrames);
  for (const std::size_t f : chosen) {
    if (f == 0 || constraint == GraspConstraint::free) {
      grasps.emplace_back().estimate.angles = fit.poses[f].angles;
      grasps.back().object = fit.object.surface;
    }
    frames.push_back(source.frame(f));
    grasps.back().frames.push_back(frames.back().get());
    grasps.back().estimate.world_from_hand.push_back(fit.poses[f].world_from_hand);
  }
}

SizedHand size_hand(const HandModel& hand, std::span<const FrameSource* const> takes,
                    const GraspFitOptions& fit_options, const Observer& observer) {
  const Stopwatch stopwatch;
  GraspFitOptions options = fit_options;
  options.joint.object_rounds = 0;
  // A hand of the wrong size leaves much uncovered from any start.
  options.seeks_again = false;
  // What a grasp drifts by says nothing of the hand's size.
  if (options.grasp == GraspConstraint::soft) options.grasp = GraspConstraint::fixed;
  double scale = start_scale(hand, *takes.front(), options, observer);
  SizedHand sized;
  for (int round = 0; round < kMostRounds; ++round) {
    sized.scale = fit_round(hand, scale, takes, options, observer);
    const double change = sized.scale.scale / scale - 1.0;
    scale = sized.scale.scale;
    if (std::abs(change) < kScaleTolerance) break;
  }
  sized.seconds = stopwatch.seconds();
  return sized;
}

}  // namespace tegata
