// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tegata/fit/border_term.h"
#include "tegata/fit/contour_term.h"
#include "tegata/fit/descent.h"
#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/hull_term.h"
#include "tegata/fit/landmark_term.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/penetration_term.h"
#include "tegata/fit/prior_term.h"

namespace tegata {

/// One set of angles and a pose for each of some frames.
struct HandEstimate {
  JointAngles angles = JointAngles::Zero();
  std::vector<Rigid3d> world_from_hand;

  HandPose pose(std::size_t frame) const { return {world_from_hand[frame], angles}; }
  std::vector<HandPose> poses() const {
    std::vector<HandPose> all;
    for (const Rigid3d& one : world_from_hand) all.push_back({one, angles});
    return all;
  }
};

/// Which terms count in a stage of the estimation; an absent term is not evaluated.
struct FitStage {
  std::optional<HullTermOptions> hull;
  std::optional<ContourTermOptions> contour;
  std::optional<BorderTermOptions> border;
  std::optional<LandmarkTermOptions> landmarks;
  PriorTermOptions prior;
  PenetrationTermOptions penetration;
  int most_iterations = 20;
  int settling_steps = 0;  ///< at most so many after these, see settle() (descent.h)
};

struct SolverReport {
  int iterations = 0;
  double energy = 0.0;                 ///< at the end, of the stage's terms
  std::vector<double> frame_energies;  ///< the parts of it that are the frames'
  Termination termination = Termination::iteration_limit;
  /// Of the angles, up to one common factor: the residuals are not independent of each other.
  ArrowSystem::AngleMatrix angle_covariance = ArrowSystem::AngleMatrix::Zero();
};

/// The terms of one frame with the hand in a pose there. With a `shape`, equations are by that as
/// well, but for those of the borders and the landmarks.
void add_frame_terms(const FitHand& hand, const PosedHand& posed, const FitFrame& frame,
                     const FitStage& stage, FrameEquations& equations,
                     const ShapeMotion* shape = nullptr);

/// What is known of the angles of a number of frames apart from any picture.
void add_angle_terms(const FitHand& hand, const JointAngles& angles, const FitStage& stage,
                     std::size_t frame_count, FrameEquations& equations);

/// Steps and estimates of frames with one set of angles, for descend() (descent.h).
/// The longest turn of a step [rad].
double longest_turn(const ArrowStep& step);
/// Beyond this turn closest points mislead [rad].
inline constexpr double kLongestTurn = 0.35;
ArrowStep shortened(ArrowStep step, double factor);
/// Whether a step is no change for a hand of this FitHand::scale.
bool is_negligible(const ArrowStep& step, double scale);
HandEstimate advanced(const HandEstimate& estimate, const ArrowStep& step);

/// Minimises the energy of all frames by damped Gauss-Newton steps (descent.h)
/// over all poses and the shared angles at once, in place. Closest points and outlines are found
/// anew at every step. Every frame is a column of the arrow-shaped system; with one frame this is
/// the fit of a single frame. Frames without any evidence keep their pose.
SolverReport minimise(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const FitStage& stage, int threads, HandEstimate& estimate);

}  // namespace tegata
