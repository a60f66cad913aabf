// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The hand of the room's tests, made once a side.
#pragma once

#include "tegata/hand/built_in_hand.h"

namespace tegata {

inline const HandModel& sim_test_hand(Side side = Side::right) {
  static const HandModel right = built_in_hand({}, Side::right, {0.004, 1500});
  static const HandModel left = mirrored(right);
  return side == Side::right ? right : left;
}

}  // namespace tegata
