// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "tegata/base/observer.h"
#include "tegata/fit/contradiction.h"
#include "tegata/fit/frame_fit.h"
#include "tegata/fit/hidden_object.h"
#include "tegata/hull/visual_hull.h"

namespace tegata {

struct JointFitOptions {
  std::vector<FitSchedule> frame = search_schedules();
  FitSchedule all_frames = grasp_schedule();
  /// Once the object is known that hides the hand.
  FitSchedule with_object = object_schedule();
  HiddenObjectOptions object;
  HullOptions hull;  ///< of the views that are left where one contradicts the others
  /// So often the object is found from the hand and the hand with the object. 0: neither it is
  /// looked for, nor digits in other places: for estimates of the hand's size.
  int object_rounds = 3;
  int threads = 0;
};

struct JointFit {
  HandEstimate estimate;
  HiddenObject object;
  SolverReport report;  ///< of the last stage; iterations of all
};

/// Fits all frames at once with one set of angles (the paper, V: simultaneous estimation), from
/// what each frame alone has found: what stands about the hand is found, digits are tried in other
/// places, frames at other poses, and views that contradict the others of their frame are left
/// out from there.
/// Frames need hulls, and there must be one or more.
JointFit fit_jointly(const FitHand& hand, AgreeingFrames& agreeing, HandEstimate start,
                     const JointFitOptions& options, const Observer& observer);

}  // namespace tegata
