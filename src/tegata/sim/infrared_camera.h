// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tegata/camera/camera.h"
#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/sim/warm_body.h"

namespace tegata {

/// What stands in the room at one moment, in world coordinates.
struct RoomScene {
  WarmSurface warm;   ///< hand and forearm
  TriangleMesh cold;  ///< the object, as warm as the room; may be empty
};

/// The mask that a perfect segmentation gives, pixel centre by pixel centre: hand where the warm
/// surface is nearest, unknown where the object is nearest, hand behind it or not.
Silhouette room_mask(const RoomScene& scene, const Camera& camera);

/// How a camera turns radiance into counts.
struct InfraredSensor {
  int bits = 8;                 ///< 8: 0 .. 255; 16: 7000 .. 9500, as thermal cameras count
  std::uint64_t room_seed = 1;  ///< background, clutter, vignetting: one for all frames of a camera
  std::uint64_t noise_seed = 1;  ///< one a picture
};

/// The picture of the scene: skin at about 0.7 before a room at about 0.25 with slow gradients and
/// lukewarm clutter, the object within 2 % of what is in the picture's middle, and hiding what is
/// behind it; edges antialiased by 4 x 4 samples a pixel, then blurred (0.9 px), darkened towards
/// the corners (10 to 20 %), noised (1 % of the range) and quantised. Throws Error on other bits
/// than 8 or 16.
CameraImage infrared_picture(const RoomScene& scene, const Camera& camera,
                             const InfraredSensor& sensor);

}  // namespace tegata
