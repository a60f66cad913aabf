// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/camera/camera.h"
#include "tegata/fit/fit_frame.h"
#include "tegata/fit/forearm.h"
#include "tegata/hand/hand_model.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// The pixels of a view that say nothing of the hand because of the arm: those that the forearm
/// covers and, of those where it may go on, what is farther from the posed hand and from what the
/// hull has before the wrist than 12 mm, for a hand of scale 1. A view along the arm shows more of
/// it than the others do, and so more than the hull has.
Silhouette forearm_picture(const FitHand& hand, const PosedHand& posed, const FitFrame& frame,
                           const Camera& camera, const Forearm& forearm);

}  // namespace tegata
