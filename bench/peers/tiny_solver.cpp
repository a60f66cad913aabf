// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Built with all that this machine has, and so with an Eigen of another name (CMakeLists.txt).
#include <ceres/tiny_solver.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "peers/hand_pairs.h"

namespace tegata::bench {
namespace {

struct Function {
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = kFlatPose + kFlatAngles };

  const FlatFrame& frame;

  int NumResiduals() const { return static_cast<int>(frame.pairs.size()); }

  // Derivatives column by column.
  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    FlatMotion motion;
    frame.motion_at(parameters, parameters + kFlatPose, motion);
    const std::size_t count = frame.pairs.size();
    std::size_t i = 0;
    for (std::size_t part = 0; part < kFlatParts; ++part) {
      const std::size_t first = i, end = frame.part_end[part];
      double row[10];
      for (; i < end; ++i) {
        residuals[i] = flat_residual(frame.pairs[i], part, motion, jacobian ? row : nullptr);
        if (jacobian == nullptr) continue;
        for (std::size_t k = 0; k < 6; ++k) jacobian[k * count + i] = row[k];
        if (part == 5) continue;
        for (std::size_t k = 0; k < 4; ++k) jacobian[(6 + 4 * part + k) * count + i] = row[6 + k];
      }
      if (jacobian == nullptr) continue;
      for (std::size_t column = 6; column < 26; ++column) {
        if ((column - 6) / 4 == part) continue;
        std::fill(jacobian + column * count + first, jacobian + column * count + end, 0.0);
      }
    }
    return true;
  }
};

struct State {
  FlatFit fit;
  ceres::TinySolver<Function> solver;
};

}  // namespace

FitWork tiny_solver_fit(const FlatFit& fit) {
  const auto state = std::make_shared<State>(State{fit, {}});
  auto& options = state->solver.options;
  options.max_num_iterations = fit.iterations + 1;  // counted from one
  options.gradient_tolerance = options.parameter_tolerance = 0.0;
  options.function_tolerance = options.cost_threshold = 0.0;
  return {[state] {
            ceres::TinySolver<Function>::Parameters parameters;
            parameters.setZero();
            std::copy(state->fit.angles.begin(), state->fit.angles.end(),
                      parameters.data() + kFlatPose);
            state->solver.Solve({state->fit.frames.front()}, &parameters);
            return std::bit_cast<std::size_t>(state->solver.summary.final_cost);
          },
          [state] { return state->solver.summary.final_cost; },
          [state] { return state->solver.summary.iterations - 1; }};
}

}  // namespace tegata::bench
