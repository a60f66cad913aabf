// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tegata/base/instruction_set.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/pair_sums.h"
#include "tegata/hand/skin_motion.h"

namespace tegata {

/// The sums of a digit's pairs: those next to its first joint, which has two angles, and to the
/// other two outwards, all about their joint's centre.
struct DigitSums {
  PairSums<2> first;
  std::array<PairSums<1>, 2> others;
};

/// Adds sum of w J^T J and of w J^T r of all digits' pairs to the equations of their frame, but no
/// cost. Returns sum of w r^2 / 2. Every instruction set gives the same bits; it must be supported.
double add_digit_sums(const std::array<DigitSums, kDigitCount>& sums, const SkinMotion& motion,
                      InstructionSet set, FrameEquations& equations);

/// The same of pairs that only the palm moves, which are about the hand's origin.
double add_palm_sums(const PairSums<0>& sums, FrameEquations& equations);

}  // namespace tegata
