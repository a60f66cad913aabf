// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/lens_range.h"

#include <limits>

namespace tegata {

double invertible_radius(const Camera& camera) {
  constexpr double kLargest = 4.0;  // 76 degrees off the axis
  constexpr double kStep = 0.005;   // 0.3 degrees near the axis
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  if (!camera.is_distorted()) return kAnywhere;
  const Lens lens = camera.lens();
  double previous = 0.0;
  for (double r = kStep; r < kLargest; r += kStep) {
    const double current = lens.distorted_radius(r);
    if (!(current > previous)) return r - kStep;
    previous = current;
  }
  return kAnywhere;
}

LensRange::LensRange(const Camera& camera)
    : center_(camera.cx, camera.cy), focal_(camera.fx, camera.fy) {
  const double radius = invertible_radius(camera);
  squared_radius_ = radius * radius;
}

bool LensRange::contains(const Eigen::Vector2d& undistorted_pixel) const {
  return ((undistorted_pixel.array() - center_) / focal_).square().sum() <= squared_radius_;
}

}  // namespace tegata
