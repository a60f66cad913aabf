// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/hand_icp.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nanoflann.hpp>

namespace tegata::bench {
namespace {

struct Cloud {
  const std::vector<double>& points;

  std::size_t kdtree_get_point_count() const { return points.size() / 3; }
  double kdtree_get_pt(std::size_t point, std::size_t axis) const {
    return points[3 * point + axis];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 3, std::uint32_t>;

struct Near {
  std::uint32_t index = 0;
  double squared_distance = 0.0;
};

Near nearest(const Tree& tree, const double* point) {
  Near near;
  tree.knnSearch(point, 1, &near.index, &near.squared_distance);
  return near;
}

// What the pairs of a round are about; the cost functions refer to it.
struct State : ceres::EvaluationCallback {
  const FlatMotionAt* motion_at = nullptr;
  const double *pose = nullptr, *angles = nullptr;
  FlatMotion motion;
  std::array<std::vector<FlatPair>, kFlatParts> pairs;

  void PrepareForEvaluation(bool, bool has_moved) override {
    if (has_moved) (*motion_at)(pose, angles, motion);
  }
};

// The pairs of a part, by the pose and the angles of its digit.
class PartCost : public ceres::CostFunction {
 public:
  PartCost(const State& state, std::size_t part) : state_(state), part_(part) {
    set_num_residuals(static_cast<int>(state.pairs[part].size()));
    mutable_parameter_block_sizes()->push_back(kFlatPose);
    if (part < 5) mutable_parameter_block_sizes()->push_back(4);
  }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    double* poses = jacobians != nullptr ? jacobians[0] : nullptr;
    double* angles = jacobians != nullptr && part_ < 5 ? jacobians[1] : nullptr;
    const std::vector<FlatPair>& pairs = state_.pairs[part_];
    double row[10];
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool asks = poses != nullptr || angles != nullptr;
      residuals[i] = flat_residual(pairs[i], part_, state_.motion, asks ? row : nullptr);
      if (poses != nullptr) std::copy(row, row + 6, poses + 6 * i);
      if (angles != nullptr) std::copy(row + 6, row + 10, angles + 4 * i);
    }
    return true;
  }

 private:
  const State& state_;
  std::size_t part_;
};

// How far the angles of a digit have gone from those before.
class ChangeCost : public ceres::SizedCostFunction<4, 4> {
 public:
  ChangeCost(const double* before, double deviation) : before_(before), share_(1.0 / deviation) {}

  bool Evaluate(double const* const* angles, double* residuals, double** jacobians) const override {
    for (std::size_t i = 0; i < 4; ++i) residuals[i] = share_ * (angles[0][i] - before_[i]);
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    std::fill(jacobians[0], jacobians[0] + 16, 0.0);
    for (std::size_t i = 0; i < 4; ++i) jacobians[0][5 * i] = share_;
    return true;
  }

 private:
  const double* before_;
  double share_;
};

// The surface where the motion takes it.
void pose_surface(const FlatHand& hand, const FlatMotion& motion, FlatHull& posed) {
  posed.points.resize(3 * hand.vertices.size());
  posed.normals.resize(3 * hand.vertices.size());
  std::size_t v = 0;
  for (std::size_t part = 0; part < kFlatParts; ++part) {
    for (; v < hand.part_end[part]; ++v) {
      const FlatPair& vertex = hand.vertices[v];
      double blend[12] = {};
      for (std::size_t i = 0; i < (part < 5 ? 4u : 1u); ++i) {
        if (vertex.weights[i] == 0.0) continue;
        const double* bone = motion.bones[i == 0 ? 0 : 3 * part + i];
        for (std::size_t k = 0; k < 12; ++k) blend[k] += vertex.weights[i] * bone[k];
      }
      for (std::size_t k = 0; k < 3; ++k) {
        posed.points[3 * v + k] = flat_dot(blend + 4 * k, vertex.rest) + blend[4 * k + 3];
        posed.normals[3 * v + k] = flat_dot(blend + 4 * k, vertex.normal);
      }
    }
  }
}

std::size_t part_of(const FlatHand& hand, std::size_t vertex) {
  std::size_t part = 0;
  while (vertex >= hand.part_end[part]) ++part;
  return part;
}

// Nearest points both ways; the plane is the found point's.
class Pairing {
 public:
  Pairing(const FlatHand& hand, const FlatHull& posed, const FlatHull& hull,
          const IcpOptions& options, State& state)
      : hand_(hand), posed_(posed), hull_(hull), options_(options), state_(state) {
    for (auto& pairs : state.pairs) pairs.clear();
  }

  void find(const Tree& hull_tree) {
    const std::size_t vertices = hand_.vertices.size(), points = hull_.points.size() / 3;
    const std::size_t step = 1 + vertices / options_.samples;
    const std::size_t hull_step = 1 + points / options_.samples;
    const double count = static_cast<double>(vertices) / static_cast<double>(step) +
                         static_cast<double>(points) / static_cast<double>(hull_step);
    root_ = std::sqrt(30.0 / count) / options_.deviation;
    for (std::size_t v = 0; v < vertices; v += step) {
      const Near near = nearest(hull_tree, &posed_.points[3 * v]);
      add(v, near.index, near.squared_distance, &hull_.normals[3 * near.index]);
    }
    const Cloud cloud{posed_.points};
    const Tree hand_tree(3, cloud);
    for (std::size_t p = 0; p < points; p += hull_step) {
      const Near near = nearest(hand_tree, &hull_.points[3 * p]);
      add(near.index, p, near.squared_distance, &posed_.normals[3 * near.index]);
    }
  }

 private:
  void add(std::size_t vertex, std::size_t point, double squared, const double* normal) {
    if (squared > options_.farthest * options_.farthest) return;
    if (flat_dot(&posed_.normals[3 * vertex], &hull_.normals[3 * point]) < 0.3) return;
    FlatPair pair = hand_.vertices[vertex];
    std::copy(normal, normal + 3, pair.normal);
    pair.offset = flat_dot(normal, &hull_.points[3 * point]);
    pair.root_weight = root_ / (1.0 + squared / (options_.sigma * options_.sigma));
    state_.pairs[part_of(hand_, vertex)].push_back(pair);
  }

  const FlatHand& hand_;
  const FlatHull &posed_, &hull_;
  const IcpOptions& options_;
  State& state_;
  double root_ = 0.0;
};

void solve(State& state, const IcpOptions& options, const double* previous, double* pose,
           double* angles) {
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &state;
  ceres::Problem problem(problem_options);
  for (std::size_t part = 0; part < kFlatParts; ++part) {
    double* const own = angles + 4 * part;
    if (part < 5) {
      problem.AddResidualBlock(new ChangeCost(previous + 4 * part, options.angle_deviation),
                               nullptr, own);
    }
    if (state.pairs[part].empty()) continue;
    auto* const cost = new PartCost(state, part);
    if (part < 5) {
      problem.AddResidualBlock(cost, nullptr, pose, own);
    } else {
      problem.AddResidualBlock(cost, nullptr, pose);
    }
  }
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  solver.max_num_iterations = options.iterations_a_round;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
}

}  // namespace

int fit_to_hull(const FlatHand& hand, const FlatMotionAt& motion_at, const FlatHull& hull,
                const IcpOptions& options, const double* previous_angles, double* pose,
                double* angles) {
  State state;
  state.motion_at = &motion_at;
  state.pose = pose;
  state.angles = angles;
  const Cloud cloud{hull.points};
  const Tree hull_tree(3, cloud);
  FlatHull posed, before;
  motion_at(pose, angles, state.motion);
  pose_surface(hand, state.motion, posed);
  for (int round = 1;; ++round) {
    Pairing(hand, posed, hull, options, state).find(hull_tree);
    solve(state, options, previous_angles, pose, angles);
    if (round == options.most_rounds) return round;
    std::swap(posed, before);
    motion_at(pose, angles, state.motion);
    pose_surface(hand, state.motion, posed);
    double longest = 0.0;
    for (std::size_t i = 0; i < posed.points.size(); ++i) {
      longest = std::max(longest, std::abs(posed.points[i] - before.points[i]));
    }
    if (longest < options.settled) return round;
  }
}

}  // namespace tegata::bench
