// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tegata/camera/camera.h"

namespace tegata {

/// Cameras on the walls and the ceiling of a room of 1.5 x 1.5 x 2 m, all looking at its middle.
/// The world's origin is the room's middle, z points up. Three stand on orthogonal axes (front,
/// side, above; the paper, VI), two at 60 to 90 degrees, more are spread over what lies above the
/// table's height. A hand in the middle takes about half of the picture's height. Placement, aim,
/// roll, focal length and lens vary a little with the seed.
struct RoomCameraOptions {
  int count = 3;
  int width = 640, height = 480;  ///< pixels
  bool distortion = true;         ///< false: ideal lenses
  std::uint64_t seed = 1;
};

/// Named "camera_0", "camera_1" ... Throws Error on fewer than two cameras or an empty picture.
CameraRig room_cameras(const RoomCameraOptions& options);

}  // namespace tegata
