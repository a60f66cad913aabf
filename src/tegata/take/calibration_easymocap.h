// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/camera/camera.h"
#include "tegata/take/calibration_import.h"
#include "tegata/take/data_tree.h"

namespace tegata {

/// Whether a file has a camera's matrix or pose as EasyMocap names them: K_<camera>, Rot_<camera>.
bool is_easymocap(const DataTree& root);

/// EasyMocap's intri.yml and extri.yml, which may be one file. Rot_<camera> is a matrix, R_<camera>
/// a rotation vector; where both are there they must agree. The size is in W_<camera>, H_<camera>,
/// or that of the options.
CameraRig read_easymocap(const DataTree& intrinsics, const DataTree& extrinsics,
                         const CalibrationImportOptions& options);

}  // namespace tegata
