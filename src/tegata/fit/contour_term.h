// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/fit/fit_hand.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/shape_motion.h"
#include "tegata/fit/view.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

struct ContourTermOptions {
  /// Of the Lorentzian kernel [m] where the hand's outline lies outside the silhouette: something
  /// cold in front removes hand pixels, so this may be no error at all.
  double sigma = 0.003;
  /// The same where hand pixels lie outside the hand's outline: nothing adds hand pixels, so this
  /// is always an error.
  double violation_sigma = 0.01;
  double standard_deviation = 0.0008;  ///< of a seen outline off the hand's [m]
  double weight = 1.0;                 ///< of the whole term
  /// Every so manieth point of the seen contour is asked, and the hand's outline is looked for in a
  /// picture of it that is so many times smaller: far from the end all tell no more.
  int coarseness = 1;
};

/// The outline in one picture, both ways: for each point of the hand's outline the distance to the
/// nearest proven border of the silhouette, and for each point of the silhouette's contour the
/// nearest outline point of the hand that faces the same way. Distances are taken into metres at
/// the depth of the outline. Borders with unknown pixels, the forearm
/// and what lies behind an object (FitView) say nothing. With a
/// `shape`, equations are by that as well.
void add_contour_term(const FitHand& hand, const PosedHand& posed, const FitView& view,
                      const ContourTermOptions& options, FrameEquations& equations,
                      const ShapeMotion* shape = nullptr);

}  // namespace tegata
