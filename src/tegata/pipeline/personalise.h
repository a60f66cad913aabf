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

struct PersonaliseOptions : PrepareOptions {
  GraspFitOptions fit;
};

/// Somebody's hand as the built-in one in a shape, and how it was found.
struct PersonalHand {
  ScaleFit scale;  ///< of the mean hand, before its parts
  ShapeFit fit;
  std::size_t frame_count = 0;  ///< that were used
  double seconds = 0.0;
};

/// Estimates the shape of one hand from recordings of it, together with all poses and angles: its
/// size first, then all shape parameters, held by shape_prior(). Throws Error where a take has no
/// frame that can be fitted.
PersonalHand personalise(std::span<Take> takes, Side side, const PersonaliseOptions& options,
                         const Observer& observer);

}  // namespace tegata
