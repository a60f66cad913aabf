// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/hand/hand_model.h"
#include "tegata/take/result.h"

namespace tegata {

/// Everything that result.json says, and the hand's surface in each frame, as arrays for NumPy:
/// docs/formats.md lists them. Numbers of frames without a pose are NaN.
std::string npz_bytes(const Result& result, const HandModel& hand);

}  // namespace tegata
