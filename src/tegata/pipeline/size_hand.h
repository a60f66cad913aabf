// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/frame_source.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/fit/shape_fit.h"

namespace tegata {

/// Grasps, and the frames that they point to.
struct KeptGrasps {
  std::vector<GraspFrames> grasps;
  std::vector<std::shared_ptr<const FitFrame>> frames;

  /// Adds what a fit found of frames spread over all: one grasp, or with free ones a grasp for each
  /// frame.
  void add(const GraspFit& fit, const FrameSource& source, GraspConstraint constraint);
};

struct SizedHand {
  ScaleFit scale;  ///< of the hand given
  double seconds = 0.0;
};

/// The scale of a hand that fits some takes of it. A hand of the wrong size settles in wrong
/// places, so a few sizes are tried on the first frames, each with poses and angles; from the best
/// on all frames are fitted and the scale with them, anew as long as it changes. Free grasps have
/// angles for each frame.
SizedHand size_hand(const HandModel& hand, std::span<const FrameSource* const> takes,
                    const GraspFitOptions& options, const Observer& observer);

}  // namespace tegata
