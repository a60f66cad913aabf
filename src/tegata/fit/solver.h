// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "tegata/fit/contour_term.h"
#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/hull_term.h"
#include "tegata/fit/landmark_term.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/prior_term.h"

namespace tegata {

/// One set of angles and a pose for each of some frames.
struct HandEstimate {
  JointAngles angles = JointAngles::Zero();
  std::vector<Rigid3d> world_from_hand;

  HandPose pose(std::size_t frame) const { return {world_from_hand[frame], angles}; }
};

/// Which terms count in a stage of the estimation; an absent term is not evaluated.
struct FitStage {
  std::optional<HullTermOptions> hull;
  std::optional<ContourTermOptions> contour;
  std::optional<LandmarkTermOptions> landmarks;
  PriorTermOptions prior;
  int most_iterations = 20;
};

enum class Termination {
  converged,    ///< the last step was below the tolerances
  no_progress,  ///< no step of any length lowered the energy
  iteration_limit,
};
std::string_view termination_name(Termination termination);

struct SolverReport {
  int iterations = 0;
  double energy = 0.0;                 ///< at the end, of the stage's terms
  std::vector<double> frame_energies;  ///< the parts of it that are the frames'
  Termination termination = Termination::iteration_limit;
  /// Of the angles, up to one common factor: the residuals are not independent of each other.
  ArrowSystem::AngleMatrix angle_covariance = ArrowSystem::AngleMatrix::Zero();
};

/// Minimises the energy of all frames by damped Gauss-Newton steps (Levenberg 1944, Marquardt 1963)
/// over all poses and the shared angles at once, in place. Closest points and outlines are found
/// anew at every step. Every frame is a column of the arrow-shaped system; with one frame this is
/// the fit of a single frame. Frames without any evidence keep their pose.
SolverReport minimise(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const FitStage& stage, int threads, HandEstimate& estimate);

}  // namespace tegata
