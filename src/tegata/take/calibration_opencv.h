// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/camera/camera.h"
#include "tegata/take/calibration_import.h"
#include "tegata/take/data_tree.h"

namespace tegata {

/// Whether these are the files of OpenCV's stereo calibration: M1, D1, M2, D2 and R, T.
bool is_opencv_stereo(const DataTree& intrinsics);

/// Two cameras, `left` and `right`; R and T take the left one's frame to the right one's. The two
/// trees may be of one file.
CameraRig read_opencv_stereo(const DataTree& intrinsics, const DataTree& extrinsics,
                             const CalibrationImportOptions& options);

/// A map for each camera, or a sequence `cameras` of maps with names, with the keys that OpenCV's
/// samples use: docs/formats.md lists them.
CameraRig read_opencv(const DataTree& root, const CalibrationImportOptions& options);

}  // namespace tegata
