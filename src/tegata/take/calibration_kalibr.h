// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/camera/camera.h"
#include "tegata/take/data_tree.h"

namespace tegata {

/// Whether a file has cameras as Kalibr writes them.
bool is_kalibr(const DataTree& root);

/// Kalibr's camchain: pinhole cameras, radtan, equidistant or no distortion. T_cn_cnm1 takes the
/// frame of the camera before to a camera's own; the first camera is the world.
CameraRig read_kalibr(const DataTree& root, double metres_per_unit);

}  // namespace tegata
