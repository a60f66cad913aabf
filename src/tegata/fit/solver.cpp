// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/solver.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tegata/base/parallel.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr double kAngleTolerance = 2e-4;   // largest turn of a step that is no change [rad]
constexpr double kLengthTolerance = 2e-5;  // largest shift of a step that is no change [m]

// A frame's terms in parts: one for each view, then what is known in space.
std::size_t part_count(const FitFrame& frame, const FitStage& stage) {
  return (stage.contour || stage.border ? frame.views.size() : 0) + 1;
}

void add_part(const FitHand& hand, const PosedHand& posed, const FitFrame& frame,
              const FitStage& stage, std::size_t part, FrameEquations& equations,
              const ShapeMotion* shape) {
  if (part + 1 < part_count(frame, stage)) {
    const FitView& view = frame.views[part];
    if (stage.contour) add_contour_term(hand, posed, view, *stage.contour, equations, shape);
    if (stage.border) add_border_term(hand, posed, view, *stage.border, equations);
    return;
  }
  if (stage.hull && frame.hull) {
    add_hull_term(hand, posed, *frame.hull, *stage.hull, equations, shape);
  }
  if (stage.landmarks && frame.landmarks) {
    add_landmark_term(hand, posed, *frame.landmarks, *stage.landmarks, equations);
  }
}

struct Part {
  std::size_t frame, number;
  FrameEquations equations;
};

void add(const FrameEquations& part, FrameEquations& sum) {
  sum.hessian += part.hessian;
  sum.gradient += part.gradient;
  sum.cost += part.cost;
}

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
    // Views are looked at side by side, so that one frame alone is quicker as well.
    std::vector<Part> parts;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      for (std::size_t p = 0; p < part_count(*frames[f], stage); ++p)
        parts.push_back({f, p, FrameEquations()});
    }
    std::vector<std::optional<PosedHand>> posed(frames.size());
    parallel_for(frames.size(), threads,
                 [&](std::size_t f) { posed[f].emplace(hand.posed(estimate.pose(f))); });
    parallel_for(parts.size(), threads, [&](std::size_t i) {
      Part& part = parts[i];
      add_part(hand, *posed[part.frame], *frames[part.frame], stage, part.number, part.equations,
               nullptr);
    });
    Linearisation result;
    result.frames.resize(frames.size());
    for (const Part& part : parts) add(part.equations, result.frames[part.frame]);
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
  bool turns_back(const ArrowStep& step, const ArrowStep& before) const {
    return step.angles.dot(before.angles) < 0.0;
  }
  ArrowStep shortened(ArrowStep step, double factor) const {
    return tegata::shortened(std::move(step), factor);
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
  for (std::size_t part = 0; part < part_count(frame, stage); ++part) {
    add_part(hand, posed, frame, stage, part, equations, shape);
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
  if (stage.settling_steps > 0) {
    const Descent settled = settle(problem, stage.settling_steps, estimate, current);
    report.iterations += settled.iterations;
    report.termination = settled.termination;
  }
  report.energy = current.energy();
  for (const FrameEquations& frame : current.frames) report.frame_energies.push_back(frame.cost);
  report.angle_covariance = ArrowSystem(current.frames, current.prior).angle_covariance();
  return report;
}

}  // namespace tegata
