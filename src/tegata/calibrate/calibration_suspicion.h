// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "tegata/calibrate/outline_rays.h"
#include "tegata/camera/camera.h"

namespace tegata {

/// What of a calibration the silhouettes contradict.
struct Suspicion {
  std::vector<std::string> cameras;  ///< to blame
  std::string message;
  double cost_before = 0.0, cost_after = 0.0;  ///< tangency_cost() [rad], with it put right
};

/// Tries what may be wrong with a rig against the tangent planes of silhouettes and gives what
/// explains them best; nothing where they agree as they are, or say nothing.
std::optional<Suspicion> suspect(const CameraRig& rig, const RigOutlines& frames);

/// The point nearest to the middle rays of the silhouettes of one frame; nothing where fewer than
/// two cameras saw something, rays are parallel or it lies behind one of the cameras.
std::optional<Eigen::Vector3d> meeting_point(const CameraRig& rig,
                                             const std::vector<std::optional<OutlineRays>>& frame);

}  // namespace tegata
