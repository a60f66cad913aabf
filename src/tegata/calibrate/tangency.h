// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tegata/calibrate/outline_rays.h"
#include "tegata/camera/camera.h"

namespace tegata {

/// How well the silhouettes of two cameras agree: a plane through both centres that touches the
/// object in one view touches it in the other (frontier points; Wong and Cipolla 2001). Nothing
/// but silhouettes is needed, and of the calibration everything enters.
struct PairTangency {
  std::size_t first = 0, second = 0;  ///< cameras of the rig
  std::size_t count = 0;              ///< of tangents that both views have whole
  double median = 0.0;                ///< of the angles between the tangent planes [rad]
};

/// By all pairs of cameras that see something together, over all frames. An angle is measured where
/// the plane touches, as what the view would have to turn; where the silhouettes' middle rays part
/// instead of meeting, the angle by which they part is added. Views with the other camera's centre
/// in or near the silhouette have no tangents.
std::vector<PairTangency> pair_tangencies(const CameraRig& rig, const RigOutlines& frames);

/// The mean of the pairs' medians, each at most 30 degrees, one that has no tangent left out.
double tangency_cost(const std::vector<PairTangency>& pairs);

}  // namespace tegata
