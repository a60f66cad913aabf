// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tegata/fit/landmark_term.h"
#include "tegata/hand/hand_model.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Angles of a few typical grasps, from nearly open to closed: where a fit may start.
std::vector<JointAngles> typical_angles();

/// The pose whose wrist and knuckles lie closest to the landmarks.
Rigid3d pose_from_landmarks(const Skeleton& skeleton, const StartLandmarks& landmarks);

/// Poses that put the hand onto a hull in many orientations: the hand's centre at the hull's, its
/// axes turned evenly over all rotations, `count` of them (super-Fibonacci spiral; Alexa 2022).
std::vector<Rigid3d> poses_around(const Skeleton& skeleton, const TriangleMesh& hull, int count);

}  // namespace tegata
