// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/hand/hand_model.h"
#include "tegata/take/result.h"

namespace tegata {

/// A BVH of the movement, y up, centimetres and degrees, as docs/formats.md describes it: the root
/// is the wrist; at rest all channels are zero, the hand is flat, its fingers point up and its back
/// to +z. Frames without a pose hold the one before. Throws Error where no frame has a pose.
std::string bvh_text(const Result& result, const HandModel& hand);

}  // namespace tegata
