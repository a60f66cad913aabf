// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tegata/fit/frame_fit.h"
#include "tegata/fit/hidden_object.h"
#include "tegata/hand/shape_parameters.h"
#include "tegata/hand/shaped_hand.h"

namespace tegata {

/// Frames with one set of angles: those of one recording, or each of its own where the grasp is
/// free.
struct GraspFrames {
  std::vector<const FitFrame*> frames;
  HandEstimate estimate;  ///< with a pose for each of the frames
  TriangleMesh object;    ///< what hides the hand without being seen, in its frame; may be empty
};

struct ShapeFitOptions {
  double scale_deviation = 0.08;  ///< of hands' sizes about the given one
  FitSchedule scale = scale_schedule();
  FitSchedule shape = shape_schedule();
  /// How often the shape is fitted, each time but the first with hidden objects as the last shape
  /// shows them.
  int shape_rounds = 2;
  HiddenObjectOptions object;
  int threads = 0;
};

/// The scale at which a hand fits best.
struct ScaleFit {
  double scale = 1.0;
  double standard_deviation = 0.0;
  double energy = 0.0;  ///< comparable between starts with the same hand and frames
  int iterations = 0;
  Termination termination = Termination::iteration_limit;
};

/// Refines poses and angles of all grasps together with the one scale of a hand, any hand, in
/// place, from a start. Throws Error where there is no frame.
ScaleFit fit_scale(const HandModel& hand, double start, std::span<GraspFrames> grasps,
                   const ShapeFitOptions& options = {});

/// The shape of the built-in hand that fits best.
struct ShapeFit {
  ShapeParameters shape;
  ShapeParameters standard_deviations;
  int iterations = 0;
  Termination termination = Termination::iteration_limit;
};

/// Refines poses and angles of all grasps together with all shape parameters, in place, from a
/// start. What no picture tells stays at shape_prior(). Grasps of several frames get the objects
/// that were found in the end. Throws Error where there is no frame.
ShapeFit fit_shape(const ShapedHand& hand, const ShapeParameters& start,
                   std::span<GraspFrames> grasps, const ShapeFitOptions& options = {});

}  // namespace tegata
