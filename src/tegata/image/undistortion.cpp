// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/undistortion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tegata/base/error.h"
#include "tegata/image/lens_range.h"

namespace tegata {

Undistortion::Undistortion(const Camera& camera)
    : camera_name_(camera.name), width_(camera.width), height_(camera.height) {
  if (!camera.is_distorted()) return;
  const LensRange range(camera);
  sources_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Eigen::Vector2d pixel(x, y);
      const Eigen::Vector2d seen = distort_pixel(camera, pixel);
      const bool is_seen = camera.contains(seen) && range.contains(pixel);
      sources_.push_back(is_seen ? static_cast<int>(std::floor(seen.y() + 0.5)) * width_ +
                                       static_cast<int>(std::floor(seen.x() + 0.5))
                                 : -1);
    }
  }
}

Silhouette Undistortion::apply(const Silhouette& silhouette) const {
  if (silhouette.width() != width_ || silhouette.height() != height_) {
    throw Error("camera '", camera_name_, "': got a silhouette of ", silhouette.width(), " x ",
                silhouette.height(), ", expected the calibration's ", width_, " x ", height_);
  }
  if (sources_.empty()) return silhouette;
  Silhouette ideal(width_, height_);
  std::transform(sources_.begin(), sources_.end(), ideal.values().begin(),
                 [labels = silhouette.values().data()](std::int32_t source) {
                   return source < 0 ? PixelLabel::unknown : labels[source];
                 });
  return ideal;
}

Silhouette undistort(const Silhouette& silhouette, const Camera& camera) {
  return Undistortion(camera).apply(silhouette);
}

}  // namespace tegata
