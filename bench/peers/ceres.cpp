// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <ceres/ceres.h>

#include <array>
#include <bit>
#include <memory>

#include "peers/hand_pairs.h"
#include "peers/peers.h"

namespace tegata::bench {
namespace {

using Pose = std::array<double, kFlatPose>;

struct State : ceres::EvaluationCallback {
  FlatFit fit;
  std::vector<Pose> poses;
  std::array<double, kFlatAngles> angles;
  std::vector<FlatMotion> motions;
  ceres::Solver::Summary summary;

  void PrepareForEvaluation(bool, bool has_moved) override {
    if (!has_moved) return;
    for (std::size_t f = 0; f < poses.size(); ++f) {
      fit.frames[f].motion_at(poses[f].data(), angles.data(), motions[f]);
    }
  }
};

// Of the pairs of some parts of a frame, by its pose and the angles of `first_angle` and after.
class PairCost : public ceres::CostFunction {
 public:
  PairCost(const State& state, std::size_t frame, std::size_t first_part, std::size_t last_part)
      : frame_(state.fit.frames[frame]),
        motion_(state.motions[frame]),
        first_part_(first_part),
        last_part_(last_part),
        begin_(first_part == 0 ? 0 : frame_.part_end[first_part - 1]) {
    set_num_residuals(static_cast<int>(frame_.part_end[last_part - 1] - begin_));
    mutable_parameter_block_sizes()->push_back(kFlatPose);
    const bool is_palm = first_part == 5, is_all = last_part - first_part == kFlatParts;
    if (!is_palm) mutable_parameter_block_sizes()->push_back(is_all ? kFlatAngles : 4);
  }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    const std::size_t width = last_part_ - first_part_ == 1 ? 4 : kFlatAngles;
    double* poses = jacobians != nullptr ? jacobians[0] : nullptr;
    double* angles = jacobians != nullptr && first_part_ < 5 ? jacobians[1] : nullptr;
    double row[10];
    std::size_t i = begin_;
    for (std::size_t part = first_part_; part < last_part_; ++part) {
      for (; i < frame_.part_end[part]; ++i) {
        const std::size_t at = i - begin_;
        residuals[at] = flat_residual(frame_.pairs[i], part, motion_, poses ? row : nullptr);
        if (poses != nullptr) std::copy(row, row + 6, poses + 6 * at);
        if (angles == nullptr) continue;
        double* own = angles + width * at;
        if (width != 4) std::fill(own, own + width, 0.0);
        if (part < 5) std::copy(row + 6, row + 10, own + (width == 4 ? 0 : 4 * part));
      }
    }
    return true;
  }

 private:
  const FlatFrame& frame_;
  const FlatMotion& motion_;
  std::size_t first_part_, last_part_, begin_;
};

void add_frame(State& state, std::size_t frame, bool by_digit, ceres::Problem& problem) {
  double* const pose = state.poses[frame].data();
  if (!by_digit) {
    problem.AddResidualBlock(new PairCost(state, frame, 0, kFlatParts), nullptr, pose,
                             state.angles.data());
    return;
  }
  for (std::size_t part = 0; part < kFlatParts; ++part) {
    auto* const cost = new PairCost(state, frame, part, part + 1);
    if (part == 5) {
      problem.AddResidualBlock(cost, nullptr, pose);
    } else {
      problem.AddResidualBlock(cost, nullptr, pose, state.angles.data() + 4 * part);
    }
  }
}

void solve(State& state, CeresSolver solver, bool by_digit) {
  state.poses.assign(state.fit.frames.size(), Pose{});
  std::copy(state.fit.angles.begin(), state.fit.angles.end(), state.angles.begin());
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &state;
  ceres::Problem problem(problem_options);
  ceres::Solver::Options options;
  constexpr ceres::LinearSolverType kSolvers[] = {ceres::DENSE_QR, ceres::DENSE_NORMAL_CHOLESKY,
                                                  ceres::SPARSE_NORMAL_CHOLESKY,
                                                  ceres::SPARSE_SCHUR};
  options.linear_solver_type = kSolvers[static_cast<std::size_t>(solver)];
  options.max_num_iterations = state.fit.iterations;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0.0;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  for (std::size_t f = 0; f < state.poses.size(); ++f) add_frame(state, f, by_digit, problem);
  if (solver == CeresSolver::sparse_schur) {
    options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    for (Pose& pose : state.poses) {
      options.linear_solver_ordering->AddElementToGroup(pose.data(), 0);
    }
    for (std::size_t i = 0; i < kFlatAngles; i += by_digit ? 4 : kFlatAngles) {
      options.linear_solver_ordering->AddElementToGroup(state.angles.data() + i, 1);
    }
  }
  ceres::Solve(options, &problem, &state.summary);
}

}  // namespace

std::string ceres_version() { return CERES_VERSION_STRING; }

FitWork ceres_fit(const FlatFit& fit, CeresSolver solver, bool by_digit) {
  const auto state = std::make_shared<State>();
  state->fit = fit;
  state->motions.resize(fit.frames.size());
  return {[state, solver, by_digit] {
            solve(*state, solver, by_digit);
            return std::bit_cast<std::size_t>(state->summary.final_cost);
          },
          [state] { return state->summary.final_cost; },
          [state] { return state->summary.num_successful_steps; }};
}

}  // namespace tegata::bench
