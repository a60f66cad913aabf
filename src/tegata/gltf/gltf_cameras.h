// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/camera/camera.h"

namespace tinygltf {
class Model;
}

namespace tegata {

/// Adds a camera and a node that puts it where it stands, in OpenCV's world, and turns it to glTF's
/// axes (y up, looking along -z); returns the node. What glTF's perspective does not know stands in
/// the camera's `extras`: `matrix` (fx, fy, cx, cy) and `size` in pixels, `distortions` in OpenCV's
/// order.
int add_gltf_camera(const Camera& camera, tinygltf::Model& model);

}  // namespace tegata
