// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "tegata/fit/frame_fit.h"

namespace tegata {

/// A finger that has settled in another one's place does not find its way out of it: every small
/// step makes things worse. Tries the bends of typical grasps and of other fingers for each digit,
/// for two fingers at once and for all, follows the most promising, and keeps what lowers the
/// energy: by the first stage of `schedule` on a few frames spread over all, until nothing does any
/// more; then by all stages on all frames. Where anything was kept, gives the report of the last
/// stage; else the estimate, which is to have settled by the same schedule, is left as it was.
/// Neither `frames` nor the schedule may be empty.
std::optional<SolverReport> reseat_digits(const FitHand& hand,
                                          std::span<const FitFrame* const> frames,
                                          const FitSchedule& schedule, int threads,
                                          HandEstimate& estimate);

}  // namespace tegata
