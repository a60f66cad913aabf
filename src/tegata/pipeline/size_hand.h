// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/fit/shape_fit.h"
#include "tegata/pipeline/prepare_take.h"

namespace tegata {

struct SizedHand {
  ScaleFit scale;                   ///< of the hand given
  std::vector<GraspFrames> grasps;  ///< with what was found of them
  double seconds = 0.0;
};

/// Adds what a fit found of frames: one grasp, or with free ones a grasp for each frame.
void add_grasps(const GraspFit& fit, const std::vector<const FitFrame*>& frames,
                GraspConstraint constraint, std::vector<GraspFrames>& grasps);

/// The scale of a hand that fits some takes of it. A hand of the wrong size settles in wrong
/// places, so a few sizes are tried on the first frames, each with poses and angles; from the best
/// on all frames are fitted and the scale with them, anew as long as it changes. Free grasps have
/// angles for each frame.
SizedHand size_hand(const HandModel& hand, std::span<const PreparedTake> takes,
                    const GraspFitOptions& options, const Observer& observer);

}  // namespace tegata
