// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "tegata/fit/descent.h"

namespace tegata {

/// An energy and its gradient by a step from where it was asked for. What bounds hold back has no
/// gradient.
struct EnergySlope {
  double energy = 0.0;
  Eigen::VectorXd gradient;
};

struct ConjugateGradientOptions {
  int most_iterations = 10;
  double energy_tolerance = 1e-4;  ///< ends where an iteration gains less, relative to the energy
  double first_step = 0.02;        ///< of the largest entry, in the units of the step
  double longest_step = 0.2;       ///< in one iteration: beyond it closest points mislead
};

/// A point on a line of search.
template <typename State>
struct LinePoint {
  double length = 0.0;
  State state;
  EnergySlope at;
};

/// A lower point on the line from `start` along `direction`, found with slopes by the rule of the
/// false position; `start` itself where there is none.
template <typename Problem, typename State>
LinePoint<State> search_line(const Problem& problem, const LinePoint<State>& start,
                             const Eigen::VectorXd& direction, double first, double longest) {
  constexpr int kMostEvaluations = 6;
  constexpr double kFlat = 0.25;  // a slope so small beside the first one is the valley's floor
  const double slope = start.at.gradient.dot(direction);
  LinePoint<State> best = start;
  double low = 0.0, low_slope = slope, high = 0.0, high_slope = 0.0;  // high 0: not known yet
  double length = std::min(first, longest);
  for (int i = 0; i < kMostEvaluations; ++i) {
    LinePoint<State> trial{length, problem.advanced(start.state, length * direction), {}};
    trial.at = problem.evaluate(trial.state);
    const double trial_slope = trial.at.gradient.dot(direction);
    const bool is_lower = trial.at.energy < best.at.energy;
    if (is_lower) best = std::move(trial);
    if (is_lower && trial_slope <= 0.0) {
      if (trial_slope >= kFlat * slope || length >= longest) break;
      low = length, low_slope = trial_slope;
    } else {
      if (is_lower && trial_slope <= -kFlat * slope) break;
      high = length, high_slope = trial_slope;
    }
    if (high == 0.0) {
      length = std::min(3.0 * length, longest);
    } else {
      const double share = high_slope > 0.0 ? low_slope / (low_slope - high_slope) : 0.3;
      length = low + std::clamp(share, 0.1, 0.9) * (high - low);
    }
  }
  return best;
}

/// Lowers an energy by conjugate gradients (Polak and Ribiere 1969; a negative factor, a direction
/// that does not descend or a line without a lower point restarts from the gradient), in place.
/// Returns the energy at the end. A problem has
///   evaluate(state): an EnergySlope;
///   advanced(state, step): the state after a step, within its bounds.
template <typename Problem, typename State>
double conjugate_gradient(const Problem& problem, const ConjugateGradientOptions& options,
                          State& state) {
  LinePoint<State> current{0.0, state, problem.evaluate(state)};
  Eigen::VectorXd direction = -current.at.gradient;
  bool is_steepest = true;
  double last_length = 0.0;
  for (int iteration = 0; iteration < options.most_iterations; ++iteration) {
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest > 0.0)) break;
    const double first = last_length > 0.0 ? last_length : options.first_step / largest;
    LinePoint<State> next =
        search_line(problem, current, direction, first, options.longest_step / largest);
    if (next.length == 0.0) {
      if (is_steepest && last_length == 0.0) break;
      direction = -current.at.gradient;
      is_steepest = true;
      last_length = 0.0;
      continue;
    }
    const double gain = current.at.energy - next.at.energy;
    const Eigen::VectorXd change = next.at.gradient - current.at.gradient;
    const double factor = std::max(
        0.0, next.at.gradient.dot(change) / std::max(current.at.gradient.squaredNorm(), 1e-300));
    const double old_slope = current.at.gradient.dot(direction);
    Eigen::VectorXd next_direction = -next.at.gradient + factor * direction;
    is_steepest = factor == 0.0 || next_direction.dot(next.at.gradient) >= 0.0;
    if (is_steepest) next_direction = -next.at.gradient;
    const double next_slope = next.at.gradient.dot(next_direction);
    last_length = next_slope < 0.0 ? next.length * old_slope / next_slope : 0.0;
    direction = std::move(next_direction);
    current = std::move(next);
    if (gain < options.energy_tolerance * current.at.energy) break;
  }
  state = current.state;
  return current.at.energy;
}

}  // namespace tegata
