// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/take/result.h"

namespace tegata {

/// OpenSim's files, y up, as docs/formats.md describes them.

/// The 21 keypoints as markers in millimetres (TRC). Cells of frames without a pose are empty.
std::string trc_text(const Result& result);

/// Where the hand is, in metres and degrees, and the 20 joint angles in degrees (MOT). Numbers of
/// frames without a pose are NaN.
std::string mot_text(const Result& result);

}  // namespace tegata
