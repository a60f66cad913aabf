// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tegata/base/observer.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/hand/hand_model.h"
#include "tegata/pipeline/prepare_take.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

enum class FitMethod {
  all_terms,  ///< hull and contours, all parameters at once: the default
  paper,      ///< fit/paper_fit.h: hull alone, pose and angles in turn
};

struct FitTakeOptions : PrepareOptions {
  FitMethod method = FitMethod::all_terms;
  GraspFitOptions fit;
};

/// The whole way of the data: pictures, silhouettes, hulls, fit of each frame, fit of all frames.
/// The hand's side must be the take's; the result says at which scale it was fitted. Frames that
/// cannot be fitted keep an entry that says why. Throws Error where nothing can be fitted at all.
Result fit_take(Take& take, const HandModel& hand, const FitTakeOptions& options,
                const Observer& observer);

}  // namespace tegata
