// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/calibrate/board_calibration.h"
#include "tegata/image/image.h"

namespace tegata {

/// A picture of each camera's picture side by side, with a dot for each point of the board that was
/// seen: green where it is reprojected to 0.5 px, yellow to 1.5 px, red beyond or left out. What
/// stays empty of dots is where the lens is not known.
CameraImage coverage_picture(const BoardRecording& recording, const BoardCalibration& calibration);

}  // namespace tegata
