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

}  // namespace tegata
