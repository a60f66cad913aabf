// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/base/observer.h"
#include "tegata/hand/hand_model.h"
#include "tegata/pipeline/prepare_take.h"
#include "tegata/take/take.h"

namespace tegata {

struct SideChoice {
  Side side = Side::right;
  double lead = 1.0;  ///< the other hand's energy over this one's: near 1 nothing is proven
};

/// Below this lead a choice is a guess.
inline constexpr double kSureSideLead = 1.1;

/// Which hand a take shows, where it does not say: both are sought from nothing in a few frames
/// spread over the selected ones, and that which fits better is it. Throws Error where no frame can
/// be fitted.
SideChoice find_side(Take& take, const HandModel& right, const HandModel& left,
                     const PrepareOptions& options, const Observer& observer);

}  // namespace tegata
