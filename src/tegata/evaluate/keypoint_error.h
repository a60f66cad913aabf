// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "tegata/hand/skeleton.h"

namespace tegata {

using Keypoints =
    std::array<Eigen::Vector3d, kKeypointCount>;  ///< in the order of keypoint_names()

/// Mean distance of the keypoints [m].
double keypoint_error(const Keypoints& fitted, const Keypoints& truth);
/// The same with both wrists moved to the origin.
double root_relative_keypoint_error(const Keypoints& fitted, const Keypoints& truth);
/// The same after the turn, shift and scale of the fitted ones that bring them closest to the truth
/// in the least-squares sense (Umeyama 1991); never a reflection.
double procrustes_keypoint_error(const Keypoints& fitted, const Keypoints& truth);

/// The angles [rad] between successive bones: for each digit wrist to first joint, to second, to
/// third, to tip; three angles a digit.
std::array<double, 15> bone_angles(const Keypoints& keypoints);
/// Mean absolute difference of the bone angles [rad].
double flexion_error(const Keypoints& fitted, const Keypoints& truth);

}  // namespace tegata
