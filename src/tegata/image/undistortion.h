// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// Silhouettes as a camera without its lens's distortion would see them (nearest pixel). From which
/// pixel each pixel of its picture comes is found once. That picture is as large as the distorted
/// one fills it: what a barrel shows beyond its edges is added, up to a quarter of its size at each
/// side, and edges that a pincushion leaves empty are cut off, up to a twentieth, since they would
/// pass for something that hides the hand. Where that is not enough, the picture keeps its size and
/// what the distorted one does not show is unknown.
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
