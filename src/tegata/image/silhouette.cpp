// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/silhouette.h"

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"
#include "tegata/image/lens_range.h"

namespace tegata {

std::size_t count_pixels(const Silhouette& silhouette, PixelLabel label) {
  return static_cast<std::size_t>(
      std::count(silhouette.values().begin(), silhouette.values().end(), label));
}

Silhouette undistort(const Silhouette& silhouette, const Camera& camera) {
  if (silhouette.width() != camera.width || silhouette.height() != camera.height) {
    throw Error("camera '", camera.name, "': got a silhouette of ", silhouette.width(), " x ",
                silhouette.height(), ", expected the calibration's ", camera.width, " x ",
                camera.height);
  }
  if (!camera.is_distorted()) return silhouette;
  const LensRange range(camera);
  Silhouette ideal(camera.width, camera.height, PixelLabel::unknown);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector2d pixel(x, y);
      const Eigen::Vector2d seen = distort_pixel(camera, pixel);
      if (!camera.contains(seen) || !range.contains(pixel)) continue;
      ideal(x, y) = silhouette(static_cast<int>(std::floor(seen.x() + 0.5)),
                               static_cast<int>(std::floor(seen.y() + 0.5)));
    }
  }
  return ideal;
}

double intersection_over_union(const Silhouette& a, const Silhouette& b) {
  if (a.width() != b.width() || a.height() != b.height()) {
    throw Error("intersection over union: got silhouettes of ", a.width(), " x ", a.height(),
                " and ", b.width(), " x ", b.height(), ", expected one size");
  }
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    const PixelLabel first = a.values()[i], second = b.values()[i];
    if (first == PixelLabel::unknown || second == PixelLabel::unknown) continue;
    const bool in_first = first == PixelLabel::hand, in_second = second == PixelLabel::hand;
    both += in_first && in_second ? 1 : 0;
    either += in_first || in_second ? 1 : 0;
  }
  return either == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(either);
}

}  // namespace tegata
