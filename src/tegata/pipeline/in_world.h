// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/camera/scene_frame.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/take/result.h"

namespace tegata {

/// A mesh of the scene where it is in the world.
TriangleMesh in_world(const SceneFrame& scene, TriangleMesh mesh);

/// A fit's result with poses and lengths of the world; those of the hand's frame become the world's
/// metres. The model's scale stays.
Result in_world(const SceneFrame& scene, Result result);

}  // namespace tegata
