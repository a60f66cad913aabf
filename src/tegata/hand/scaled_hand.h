// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/hand/hand_model.h"

namespace tegata {

/// Any hand with every length multiplied. Throws Error for a factor that is not above zero.
HandModel scaled(HandModel model, double factor);

}  // namespace tegata
