// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/fit/forearm.h"
#include "tegata/fit/view.h"
#include "tegata/hand/hand_model.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// The pixels of a view that say nothing of the hand because of the arm: those that the forearm
/// covers and, where it ends within the picture, what is seen to go on from there. It does in views
/// along the arm: these show more of it than the others do, and so more than the hull has. What is
/// less than 12 mm beside the posed hand, for a hand of scale 1, goes on nowhere.
Silhouette forearm_picture(const FitHand& hand, const PosedHand& posed, const FitView& view,
                           const Forearm& forearm);

}  // namespace tegata
