// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/fit/fit_hand.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/view.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

struct BorderTermOptions {
  /// As those of the contour term (contour_term.h).
  double sigma = 0.0025;
  double violation_sigma = 0.008;
  double standard_deviation = 0.0008;
  double weight = 1.0;
};

/// The outline in one picture, both ways, as the contour term (contour_term.h) has it, but nearly
/// without jumps as the hand moves, at two to three times the cost: for the end of a fit, which is
/// then the same wherever it came from. Pieces of the outline count by their length as far as they
/// are seen, what faces another way fades, distances are across the outline, and only hand pixels
/// that the model does not cover are violations.
void add_border_term(const FitHand& hand, const PosedHand& posed, const FitView& view,
                     const BorderTermOptions& options, FrameEquations& equations);

}  // namespace tegata
