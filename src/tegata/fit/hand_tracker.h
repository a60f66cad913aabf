// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/frame_fit.h"

namespace tegata {

struct TrackOptions {
  /// How far the angles may change from one frame to the next [rad].
  double drift = 0.004;
  /// From where the hand is expected to where it is; its energies are compared from frame to frame.
  /// Where the last stage alone leaves no more energy than usual the ones before are not needed.
  FitSchedule follow = stream_schedule();
  /// Where it is not known where the hand is; for these a frame needs its hull.
  std::vector<FitSchedule> search = search_schedules();
  int threads = 0;
};

enum class TrackState {
  followed,  ///< from the frame before
  found,     ///< anew: in the first frame or after it was lost
  lost,      ///< nothing fits: there is no pose
};

struct TrackedFrame {
  TrackState state = TrackState::lost;
  HandPose pose;  ///< of the frame; without meaning where the hand is lost
  /// What is known of the grasp from all frames so far, and how well [rad].
  JointAngles angles, standard_deviations;
};

/// Follows a hand through a stream of frames, one at a time: each from where the hand would be if
/// it went on as before, with the angles held as near those known so far as they are known. Where
/// that fits no longer the hand is sought from nothing. Keeps nothing of the frames. Refers to the
/// hand, which must outlive it.
class HandTracker {
 public:
  HandTracker(const FitHand& hand, const TrackOptions& options);

  /// Whether the next frame is of use only with its hull.
  bool is_lost() const { return !last_; }
  /// Without a hull a frame in which the hand is lost stays so; it may be given again with one.
  TrackedFrame next(const FitFrame& frame);

 private:
  FitSchedule with_known_angles() const;
  std::optional<FrameFit> follow(const FitFrame& frame) const;
  std::optional<FrameFit> search(const FitFrame& frame) const;
  /// Of the last frames; infinite where they are too few to tell.
  double usual_energy() const;
  bool is_hand(const FitFrame& frame, const FrameFit& fit) const;
  void learn(const FrameFit& fit);

  const FitHand& hand_;
  TrackOptions options_;
  std::optional<Rigid3d> last_, last_but_one_;
  JointAngles angles_ = relaxed_angles();
  JointAngles deviations_ = JointAngles::Constant(1.0);  // [rad]
  // Of the last frames in which the hand was; empty as long as nothing is known of its angles.
  std::deque<double> energies_;
};

}  // namespace tegata
