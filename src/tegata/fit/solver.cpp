// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/solver.h"

#include <algorithm>

#include "tegata/base/parallel.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr double kAngleTolerance = 2e-4;   // largest turn of a step that is no change [rad]
constexpr double kLengthTolerance = 2e-5;  // largest shift of a step that is no change [m]

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

// What descend() asks for.
struct Problem {
  const FitHand& hand;
  std::span<const FitFrame* const> frames;
  const FitStage& stage;
  int threads;

  Linearisation linearise(const HandEstimate& estimate) const {
    Linearisation result;
    result.frames.resize(frames.size());
    parallel_for(frames.size(), threads, [&](std::size_t f) {
      const PosedHand posed = hand.posed(estimate.pose(f));
      add_frame_terms(hand, posed, *frames[f], stage, result.frames[f]);
    });
    add_angle_terms(hand, estimate.angles, stage, frames.size(), result.prior);
    return result;
  }
  ArrowStep step(const Linearisation& at, double damping) const {
    ArrowStep step = ArrowSystem(at.frames, at.prior).solve(damping);
    const double turn = longest_turn(step);
    return turn > kLongestTurn ? shortened(std::move(step), kLongestTurn / turn) : step;
  }
  bool is_negligible(const ArrowStep& step) const {
    return tegata::is_negligible(step, hand.scale);
  }
  HandEstimate advanced(const HandEstimate& estimate, const ArrowStep& step) const {
    return tegata::advanced(estimate, step);
  }
};

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

void add_frame_terms(const FitHand& hand, const PosedHand& posed, const FitFrame& frame,
                     const FitStage& stage, FrameEquations& equations, const ShapeMotion* shape) {
  if (stage.hull && frame.hull) {
    add_hull_term(hand, posed, *frame.hull, *stage.hull, equations, shape);
  }
  if (stage.contour) {
    for (const FitView& view : frame.views) {
      add_contour_term(hand, posed, view, *stage.contour, equations, shape);
    }
  }
  if (stage.landmarks && frame.landmarks) {
    add_landmark_term(hand, posed, *frame.landmarks, *stage.landmarks, equations);
  }
}

void add_angle_terms(const FitHand& hand, const JointAngles& angles, const FitStage& stage,
                     std::size_t frame_count, FrameEquations& equations) {
  add_prior_term(angles, stage.prior, frame_count, equations);
  add_penetration_term(hand.model->skeleton, hand.capsules, angles, stage.penetration, hand.scale,
                       static_cast<double>(frame_count), equations);
}

double longest_turn(const ArrowStep& step) {
  double longest = step.angles.cwiseAbs().maxCoeff();
  for (const auto& pose : step.poses) longest = std::max(longest, pose.head<3>().norm());
  return longest;
}

ArrowStep shortened(ArrowStep step, double factor) {
  step.angles *= factor;
  step.shape *= factor;
  for (auto& pose : step.poses) pose *= factor;
  return step;
}

bool is_negligible(const ArrowStep& step, double scale) {
  if (step.angles.cwiseAbs().maxCoeff() > kAngleTolerance) return false;
  return std::all_of(step.poses.begin(), step.poses.end(), [&](const auto& pose) {
    return pose.template head<3>().norm() <= kAngleTolerance &&
           pose.template tail<3>().norm() <= kLengthTolerance * scale;
  });
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

SolverReport minimise(const FitHand& hand, std::span<const FitFrame* const> frames,
                      const FitStage& stage, int threads, HandEstimate& estimate) {
  const Problem problem{hand, frames, stage, threads};
  Linearisation current = problem.linearise(estimate);
  const Descent descent = descend(problem, stage.most_iterations, estimate, current);
  SolverReport report;
  report.iterations = descent.iterations;
  report.termination = descent.termination;
  report.energy = current.energy();
  for (const FrameEquations& frame : current.frames) report.frame_energies.push_back(frame.cost);
  report.angle_covariance = ArrowSystem(current.frames, current.prior).angle_covariance();
  return report;
}

}  // namespace tegata
