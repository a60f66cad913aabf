// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/paper_fit.h"
#include "tegata/pipeline/prepare_take.h"

namespace tegata {

/// The usable frames as the paper's method wants them; they point into the take.
std::vector<PaperFrame> paper_frames(const PreparedTake& take);

/// The fit of a take by the paper's method, as fit_grasp() says it: the deviations are the spread
/// of the single frames' angles, the object is not looked for.
GraspFit fit_grasp_by_paper(const FitHand& hand, const PreparedTake& take,
                            const GraspFitOptions& options, const Observer& observer);

}  // namespace tegata
