// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/frame_source.h"
#include "tegata/fit/joint_fit.h"
#include "tegata/fit/start.h"

namespace tegata {

enum class GraspConstraint {
  fixed,  ///< one set of angles for all frames (the paper, V: simultaneous estimation)
  soft,   ///< the same, from which each frame's own depart a little: real grasps drift
  free,   ///< each frame has its own
};

struct GraspFitOptions {
  GraspConstraint grasp = GraspConstraint::fixed;
  JointFitOptions joint;
  /// The angles come from so many frames spread over all; of the others the poses alone are sought,
  /// few by few: more frames are not kept at a time.
  std::size_t most_joint_frames = 40;
  /// Whether all is done once more from another frame where the first try probably began wrong.
  bool seeks_again = true;
  int threads = 0;
};

/// The frame from which the others were found.
struct GraspStart {
  std::size_t frame = 0;                                  ///< by position
  double lead = std::numeric_limits<double>::infinity();  ///< FrameFit::lead of its pose
};

struct GraspFit {
  std::vector<HandPose> poses;      ///< one a frame
  JointAngles angles;               ///< shared, or the mean of the frames'
  JointAngles standard_deviations;  ///< of `angles` [rad]
  HiddenObject object;              ///< empty with a free grasp
  /// Cameras whose views contradicted the others and were left out, for each frame.
  std::vector<std::vector<std::string>> left_out;
  std::optional<GraspStart> start;  ///< empty where the poses were given
  int iterations = 0;
  Termination termination = Termination::iteration_limit;
  double frame_seconds = 0.0, all_frames_seconds = 0.0;
};

/// Finds the hand in all frames: the first from its landmarks or, without them, from many poses at
/// the ends of its hull, and where that leaves much of the seen hand uncovered, the last and the
/// middle one as well; from the one that covers most on to the others, each by the one before, and
/// from the ends of its hull as well where that fits far worse than frames did before; then frames
/// spread over all at once with one set of angles (joint_fit.h), so that frames in which something
/// hides a finger lose their influence on it; then the others with these angles. Views that
/// contradict the others of their frame are left out (contradiction.h). Where much more of the seen
/// hand lies beside the fitted one than where that began, all is done once more from the next
/// likeliest frame, and what covers most of the hand is kept. A soft grasp lets each frame's angles
/// depart from there last. `frames` must not be empty and each needs a hull; throws Error
/// otherwise.
GraspFit fit_grasp(const FitHand& hand, const FrameSource& frames, const GraspFitOptions& options,
                   const Observer& observer);

}  // namespace tegata
