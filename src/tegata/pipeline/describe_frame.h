// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/fit/fit_hand.h"
#include "tegata/pipeline/prepare_frame.h"
#include "tegata/take/result.h"

namespace tegata {

/// What a result says of a frame in which the hand was found: keypoints, support, overlaps,
/// verdict.
ResultFrame describe_frame(const FitHand& hand, const HandPose& pose,
                           const PreparedFrame& prepared);

/// What it says of a frame without a pose, and why there is none.
ResultFrame describe_missing(const PreparedFrame& prepared, const std::string& why);

}  // namespace tegata
