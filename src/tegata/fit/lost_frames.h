// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tegata/fit/frame_fit.h"
#include "tegata/fit/frame_source.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// How much of the seen hand lies beside the fitted one in most of a frame's views [m]: one view
/// that lies says nothing of where the hand is. All of it in a view that shows none of the hand
/// where it was fitted (kLeastSeenOverlap).
double uncovered_in_most(const FitHand& hand, const FitFrame& frame, const HandPose& pose);
/// With more than this the hand is probably elsewhere in a frame: far more than in most frames,
/// whose uncovered_in_most() is given [m]; not empty.
double most_uncovered(const FitHand& hand, const std::vector<double>& uncovered);

/// What is known of a grasp when lost frames are sought.
struct KnownGrasp {
  const JointAngles& angles;
  const TriangleMesh& object;  ///< what hides the hand, in its frame; may be empty
  const FitSchedule& schedule;
};

/// Seeks the hand in frames that leave too much of it uncovered from where their neighbours have
/// it, first forwards, then backwards, so that of several frames in a row each finds it by the one
/// before. A pose is kept where it leaves less uncovered; cameras that were left out of such a
/// frame are taken in again where they agree with it.
/// @param poses of the frames, in place
/// @param left_out cameras left out of each frame, in place
void find_lost_frames(const FitHand& hand, const FrameSource& frames, const KnownGrasp& grasp,
                      int threads, std::vector<HandPose>& poses,
                      std::vector<std::vector<std::string>>& left_out);

}  // namespace tegata
