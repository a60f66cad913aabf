// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tegata/base/instruction_set.h"
#include "tegata/image/image.h"

namespace tegata {

/// The widest band that banded_distance() measures [px].
inline constexpr int kMostBand = 120;

/// signed_distance() of distance_transform.h, limited to -band .. band [px], of the set of pixels
/// that are not zero. Far cheaper where the band is narrow. `band` is 1 to kMostBand; every
/// instruction set gives the same bits.
Image<float> banded_distance(const Image<std::uint8_t>& mask, int band,
                             InstructionSet set = best_instruction_set());

}  // namespace tegata
