// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>

namespace tegata {

enum class Termination {
  converged,    ///< the last step was below the tolerances
  no_progress,  ///< no step of any length lowered the energy
  iteration_limit,
};
std::string_view termination_name(Termination termination);

struct Descent {
  int iterations = 0;
  Termination termination = Termination::iteration_limit;
};

/// Lowers an energy by damped Gauss-Newton steps (Levenberg 1944, Marquardt 1963), in place.
/// `current` is the problem's linearisation at the estimate, before and after. A problem has
///   linearise(estimate): what is to be solved, with an energy();
///   step(linearisation, damping): as long as closest points can be trusted;
///   is_negligible(step);
///   advanced(estimate, step): the estimate after it.
template <typename Problem, typename Estimate, typename Linearisation>
Descent descend(const Problem& problem, int most_iterations, Estimate& estimate,
                Linearisation& current) {
  constexpr double kFirstDamping = 1e-3, kLeastDamping = 1e-7, kMostDamping = 1e6;
  constexpr double kEnergyTolerance = 1e-5;  // relative gain of a step that is no change
  Descent descent;
  double damping = kFirstDamping;
  while (descent.iterations < most_iterations) {
    ++descent.iterations;
    const auto step = problem.step(current, damping);
    if (problem.is_negligible(step)) {
      descent.termination = Termination::converged;
      break;
    }
    Estimate trial = problem.advanced(estimate, step);
    Linearisation ahead = problem.linearise(trial);
    const double gain = current.energy() - ahead.energy();
    if (gain > 0.0) {
      const bool is_settled = gain < kEnergyTolerance * current.energy();
      estimate = std::move(trial);
      current = std::move(ahead);
      damping = std::max(0.2 * damping, kLeastDamping);
      if (is_settled) {
        descent.termination = Termination::converged;
        break;
      }
    } else {
      damping *= 8.0;
      if (damping > kMostDamping) {
        descent.termination = Termination::no_progress;
        break;
      }
    }
  }
  return descent;
}

/// Goes on by Gauss-Newton steps whether they lower the energy or not, to where they end: closest
/// points and outlines change from step to step, so that the energy has small jumps, and a descent
/// ends before any of them, wherever it came from. What the steps weigh has smaller ones. Where a
/// step turns back, it and the next ones are taken in part. Stays where the descent has ended if
/// the energy rises by more than jumps do. A problem has, beside what descend() asks for,
///   turns_back(step, step before) and shortened(step, factor).
template <typename Problem, typename Estimate, typename Linearisation>
Descent settle(const Problem& problem, int most_steps, Estimate& estimate, Linearisation& current) {
  constexpr double kDamping = 1e-3;
  constexpr double kShorter = 0.6, kLonger = 1.2;
  constexpr double kMostRise = 1.2;
  Descent descent;
  Estimate trial = estimate;
  Linearisation ahead = current;
  double factor = 1.0;
  auto before = problem.step(ahead, kDamping);
  while (descent.iterations < most_steps) {
    ++descent.iterations;
    auto step = problem.step(ahead, kDamping);
    factor = problem.turns_back(step, before) ? kShorter * factor : std::min(1.0, kLonger * factor);
    before = step;
    step = problem.shortened(std::move(step), factor);
    trial = problem.advanced(trial, step);
    ahead = problem.linearise(trial);
    if (problem.is_negligible(step)) {
      descent.termination = Termination::converged;
      break;
    }
  }
  if (ahead.energy() <= kMostRise * current.energy()) {
    estimate = std::move(trial);
    current = std::move(ahead);
  }
  return descent;
}

}  // namespace tegata
