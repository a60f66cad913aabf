// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// Silhouettes as a camera without its lens's distortion would see them (nearest pixel). From which
/// pixel each pixel of its picture comes is found once. Along the edges of a picture of the same
/// size there may be pixels that the distorted one does not show: those would pass for something
/// that hides the hand. The picture is cut to what is shown, where that takes a twentieth of its
/// size at each side at most; they are unknown otherwise.
class Undistortion {
 public:
  explicit Undistortion(const Camera& camera);
  /// The camera without distortion, of the size of the pictures that apply() gives.
  const Camera& camera() const { return ideal_; }
  /// Throws Error, naming the camera, where the silhouette has another size than the calibration's.
  Silhouette apply(const Silhouette& silhouette) const;

 private:
  int width_, height_;                 // of the distorted picture
  Camera ideal_;                       // of the undistorted one
  std::vector<std::int32_t> sources_;  // of its pixels; -1: outside; empty where the lens is ideal
};

}  // namespace tegata
