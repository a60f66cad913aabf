// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/contour.h"
#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// What the fit needs of one picture: an undistorted camera and what it saw.
struct FitView {
  Camera camera;
  Silhouette silhouette;
  Image<float> distance;              ///< signed, to the border of the hand [px]
  std::vector<ContourPoint> contour;  ///< proven border of the hand
};

/// Computes distance and contour. The camera must be undistorted and of the silhouette's size.
FitView make_fit_view(const Camera& camera, Silhouette silhouette);

}  // namespace tegata
