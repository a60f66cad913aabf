// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/solver.h"

#include <algorithm>

#include "tegata/base/parallel.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kMostDamping = 1e6;
constexpr double kAngleTolerance = 2e-4;   // largest turn of a step that is no change [rad]
constexpr double kLengthTolerance = 2e-5;  // largest shift of a step that is no change [m]
constexpr double kEnergyTolerance = 1e-5;  // relative gain of a step that is no change
constexpr double kLongestTurn = 0.35;      // of one step: beyond, closest points mislead [rad]

// The energy of all frames at an estimate and its normal equations.
struct Linearisation {
  std::vector<FrameEquations> frames;
  FrameEquations prior;

  double energy() const {
    double sum = prior.cost;
    for (const FrameEquations& frame : frames) sum += frame.cost;
    return sum;
  }
};

Linearisation linearise(const FitHand& hand, std::span<const FitFrame* const> frames,
                        const FitStage& stage, int threads, const HandEstimate& estimate) {
  Linearisation result;
  result.frames.resize(frames.size());
  parallel_for(frames.size(), threads, [&](std::size_t f) {
    const PosedHand posed(*hand.model, estimate.pose(f));
    FrameEquations& equations = result.frames[f];
    if (stage.hull && frames[f]->hull) {
      add_hull_term(hand, posed, *frames[f]->hull, *stage.hull, equations);
    }
    if (stage.contour) {
      for (const FitView& view : frames[f]->views) {
        add_contour_term(hand, posed, view, *stage.contour, equations);
      }
    }
    if (stage.landmarks && frames[f]->landmarks) {
      add_landmark_term(hand, posed, *frames[f]->landmarks, *stage.landmarks, equations);
    }
  });
  add_prior_term(estimate.angles, stage.prior, result.prior);
  return result;
}

// Shortens a step so that nothing turns further than closest points can be trusted for.
void limit(ArrowStep& step) {
  double largest = step.angles.cwiseAbs().maxCoeff();
  for (const auto& pose : step.poses) largest = std::max(largest, pose.head<3>().norm());
  if (largest <= kLongestTurn) return;
  const double factor = kLongestTurn / largest;
  step.angles *= factor;
  for (auto& pose : step.poses) pose *= factor;
}

HandEstimate advanced(const HandEstimate& estimate, const ArrowStep& step) {
  HandEstimate next = estimate;
  next.angles += step.angles;
  for (std::size_t f = 0; f < step.poses.size(); ++f) {
    Rigid3d& pose = next.world_from_hand[f];
    pose.rotation = (so3_exp(step.poses[f].head<3>()) * pose.rotation).normalized();
    pose.translation += step.poses[f].tail<3>();
  }
  return next;
}

bool is_negligible(const ArrowStep& step, double scale) {
  if (step.angles.cwiseAbs().maxCoeff() > kAngleTolerance) return false;
  return std::all_of(step.poses.begin(), step.poses.end(), [&](const auto& pose) {
    return pose.template head<3>().norm() <= kAngleTolerance &&
           pose.template tail<3>().norm() <= kLengthTolerance * scale;
  });
}

}  // namespace

std::string_view termination_name(Termination termination) {
  switch (termination) {
    case Termination::converged:
      return "converged";
    case Termination::no_progress:
      return "no progress";
    case Termination::iteration_limit:
      return "iteration limit";
  }
  return "";
}

SolverReport minimise(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const FitStage& stage, int threads, HandEstimate& estimate) {
  SolverReport report;
  Linearisation current = linearise(hand, frames, stage, threads, estimate);
  double damping = kFirstDamping;
  bool is_settled = false;
  while (!is_settled && report.iterations < stage.most_iterations) {
    ++report.iterations;
    ArrowStep step = ArrowSystem(current.frames, current.prior).solve(damping);
    limit(step);
    if (is_negligible(step, hand.scale)) {
      report.termination = Termination::converged;
      break;
    }
    const HandEstimate trial = advanced(estimate, step);
    Linearisation ahead = linearise(hand, frames, stage, threads, trial);
    const double gain = current.energy() - ahead.energy();
    if (gain > 0.0) {
      if (gain < kEnergyTolerance * current.energy()) {
        report.termination = Termination::converged;
        is_settled = true;
      }
      estimate = trial;
      current = std::move(ahead);
      damping = std::max(0.2 * damping, 1e-7);
    } else {
      damping *= 8.0;
      if (damping > kMostDamping) {
        report.termination = Termination::no_progress;
        is_settled = true;
      }
    }
  }
  report.energy = current.energy();
  for (const FrameEquations& frame : current.frames) report.frame_energies.push_back(frame.cost);
  report.angle_covariance = ArrowSystem(current.frames, current.prior).angle_covariance();
  return report;
}

}  // namespace tegata
