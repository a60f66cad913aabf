// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/camera/camera.h"

namespace tegata {

/// The radius on the plane z = 1 up to which the lens moves points outwards when they move
/// outwards. Beyond it the radial polynomial folds back, and directions far outside the picture
/// would land within it. At most 4 (76 degrees off the axis), also for an ideal lens.
double invertible_radius(const Camera& camera);

/// Whether a position in the picture of camera.undistorted() is within that radius.
class LensRange {
 public:
  explicit LensRange(const Camera& camera);
  bool contains(const Eigen::Vector2d& undistorted_pixel) const;

 private:
  Eigen::Array2d center_, focal_;
  double squared_radius_;
};

}  // namespace tegata
