// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/built_in_hand.h"

namespace tegata {

HandModel built_in_hand(const HandShape& shape, Side side, const BuiltInHandOptions& options) {
  check_shape(shape);
  return ShapedHand(side, options).model(shape);
}

}  // namespace tegata
