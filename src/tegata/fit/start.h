// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// Angles of a few typical grasps, from nearly open to closed: where a fit may start.
std::vector<JointAngles> typical_angles();

/// The pose whose wrist and knuckles lie closest to the landmarks.
Rigid3d pose_from_landmarks(const Skeleton& skeleton, const StartLandmarks& landmarks);

/// An end of a hull where the hand may be.
struct HullEnd {
  Eigen::Vector3d tip;        ///< its outermost point, world [m]
  Eigen::Vector3d center;     ///< of what lies within a hand's length of the tip, world [m]
  Eigen::Vector3d direction;  ///< unit, along the forearm towards the tip
};

/// Where the hand may be. Where the edge of a picture cuts the hull off, that is the forearm and
/// the hand is the end farthest from it; otherwise both ends of the hull's longest axis are
/// possible. The frame needs a hull; throws Error otherwise.
std::vector<HullEnd> hand_ends(const FitHand& hand, const FitFrame& frame);

/// Poses that put the hand onto each of the hull's ends, with the forearm along the hull, turned
/// about it all around and tilted to either side.
std::vector<Rigid3d> poses_at_ends(const FitHand& hand, const std::vector<HullEnd>& ends);

/// Where a fit of a frame may start that nothing else is known of: at its landmarks or, without
/// them, at the hull's ends, with each of the given angles. The frame needs the one or the other;
/// throws Error otherwise.
std::vector<HandPose> starts_from_nothing(const FitHand& hand, const FitFrame& frame,
                                          const std::vector<JointAngles>& angles);

}  // namespace tegata
