// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/frame_fit.h"
#include "tegata/fit/hidden_object.h"
#include "tegata/fit/start.h"

namespace tegata {

enum class GraspConstraint {
  fixed,  ///< one set of angles for all frames (the paper, V: simultaneous estimation)
  free,   ///< each frame has its own
};

struct GraspFitOptions {
  GraspConstraint grasp = GraspConstraint::fixed;
  std::vector<FitSchedule> frame = {hull_first_schedule(), contour_first_schedule()};
  FitSchedule all_frames = grasp_schedule();
  /// Once the object is known that hides the hand.
  FitSchedule with_object = object_schedule();
  HiddenObjectOptions object;
  /// So often the object is found from the hand and the hand with the object. 0: neither it is
  /// looked for, nor digits in other places: for estimates of the hand's size.
  int object_rounds = 3;
  int threads = 0;
};

struct GraspFit {
  std::vector<HandPose> poses;      ///< one a frame
  JointAngles angles;               ///< shared, or the mean of the frames'
  JointAngles standard_deviations;  ///< of `angles` [rad]
  HiddenObject object;              ///< empty with a free grasp
  int iterations = 0;
  Termination termination = Termination::iteration_limit;
  double frame_seconds = 0.0, all_frames_seconds = 0.0;
};

/// Finds the hand in all frames: the first from its landmarks or, without them, from many poses at
/// the ends of its hull; each next one from the one before, and from the ends of its hull as well
/// where that fits far worse than frames did before; then all frames at once with one set of
/// angles, so that frames in which something hides a finger lose their influence on it. Fingers are
/// then tried in other places, frames that fit worse than the others sought anew with the angles
/// known, and all fitted once more. Then what hides the hand is found by what it hides, and what
/// lies behind it says nothing any more.
/// `frames` must not be empty and each needs a hull; throws Error otherwise.
GraspFit fit_grasp(const FitHand& hand, std::span<const FitFrame* const> frames,
                   const GraspFitOptions& options, const Observer& observer);

}  // namespace tegata
