// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/fit/shape_fit.h"
#include "tegata/pipeline/prepare_take.h"

namespace tegata {

struct SizedHand {
  ScaleFit scale;                   ///< of the hand given
  std::vector<GraspFrames> grasps;  ///< with what was found of them
  double seconds = 0.0;
};

/// The scale of a hand that fits some takes of it: fits each with the hand as it is, then with
/// poses and angles the scale, and once more from the beginning with the hand of that scale, as one
/// of another size settles in other places. Free grasps have angles for each frame.
SizedHand size_hand(const HandModel& hand, std::span<const PreparedTake> takes,
                    const GraspFitOptions& options, const Observer& observer);

}  // namespace tegata
