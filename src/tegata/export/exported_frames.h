// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "tegata/hand/hand_model.h"
#include "tegata/take/result.h"

namespace tegata {

/// What the formats for other programs have in common.

/// A file of an export: its name, with folders, and its bytes.
struct ExportedFile {
  std::string name, content;
};

/// Takes the world to the y up of BVH, OpenSim and glTF: half a turn about x.
Rigid3d y_up_from_world();

/// The time from one frame to the next if they were evenly spaced; 1/30 s for fewer than two [s].
double frame_interval(const Result& result);

/// For each frame its pose, or the last one before it, or where there is none before it the first
/// one after it. Throws Error where no frame has a pose.
std::vector<const HandPose*> held_poses(const Result& result);

/// Throws Error unless the hand is the one that was fitted: of the same side, and with its
/// keypoints within 0.1 mm of the result's.
void check_fitted_hand(const Result& result, const HandModel& hand);

/// Angles z, y, x [rad] with rotation = Rz(z) Ry(y) Rx(x): of all such the ones next to `before`,
/// so that a movement has no jumps.
Eigen::Vector3d zyx_angles(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& before);

/// A number with so many decimals and a point whatever the user's language; no "-0".
std::string decimal(double number, int decimals);

/// A cell of a CSV table whose content may hold anything (RFC 4180).
std::string csv_cell(const std::string& content);

}  // namespace tegata
