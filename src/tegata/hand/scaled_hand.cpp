// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/scaled_hand.h"

#include <cmath>

#include "tegata/base/error.h"

namespace tegata {

HandModel scaled(HandModel model, double factor) {
  if (!(factor > 0.0 && std::isfinite(factor))) {
    throw Error("hand '", model.name, "': the scale is ", factor, ", expected a number above 0");
  }
  for (Eigen::Vector3d& keypoint : model.skeleton.keypoints) keypoint *= factor;
  for (Eigen::Vector3d& vertex : model.rest_surface.vertices) vertex *= factor;
  return model;
}

}  // namespace tegata
