// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// undistort() for many pictures of one camera: from which pixel each pixel of
/// camera.undistorted()'s picture comes is found once.
class Undistortion {
 public:
  explicit Undistortion(const Camera& camera);
  /// Throws Error, naming the camera, where the silhouette has another size.
  Silhouette apply(const Silhouette& silhouette) const;

 private:
  std::string camera_name_;
  int width_, height_;
  std::vector<std::int32_t> sources_;  // -1: outside; empty where the lens is ideal
};

}  // namespace tegata
