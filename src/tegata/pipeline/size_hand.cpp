// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/size_hand.h"

#include <cmath>

#include "tegata/base/stopwatch.h"
#include "tegata/hand/scaled_hand.h"

namespace tegata {
namespace {

constexpr int kMostRounds = 3;
// A round that changes the scale by less was the last.
constexpr double kScaleTolerance = 0.015;

void add_grasps(const GraspFit& fit, const std::vector<const FitFrame*>& frames,
                GraspConstraint constraint, std::vector<GraspFrames>& grasps) {
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (f == 0 || constraint == GraspConstraint::free) {
      grasps.emplace_back().estimate.angles = fit.poses[f].angles;
    }
    grasps.back().frames.push_back(frames[f]);
    grasps.back().estimate.world_from_hand.push_back(fit.poses[f].world_from_hand);
  }
}

}  // namespace

SizedHand size_hand(const HandModel& hand, std::span<const PreparedTake> takes,
                    const GraspFitOptions& options, const Observer& observer) {
  const Stopwatch stopwatch;
  SizedHand sized;
  double scale = 1.0;
  for (int round = 0; round < kMostRounds; ++round) {
    const HandModel current = scaled(hand, scale);
    const FitHand fit_hand(current);
    sized.grasps.clear();
    for (const PreparedTake& take : takes) {
      const std::vector<const FitFrame*> frames = take.fit_frames();
      add_grasps(fit_grasp(fit_hand, frames, options, observer), frames, options.grasp,
                 sized.grasps);
    }
    observer.progress("size", static_cast<std::size_t>(round), kMostRounds);
    ShapeFitOptions shape_options;
    shape_options.threads = options.threads;
    sized.scale = fit_scale(hand, scale, sized.grasps, shape_options);
    const double change = sized.scale.scale / scale - 1.0;
    scale = sized.scale.scale;
    if (std::abs(change) < kScaleTolerance) break;
  }
  observer.progress("size", kMostRounds, kMostRounds);
  sized.seconds = stopwatch.seconds();
  return sized;
}

}  // namespace tegata
