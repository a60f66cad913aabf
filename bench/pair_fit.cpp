// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "pair_fit.h"

#include <algorithm>

#include "tegata/base/random.h"
#include "tegata/fit/surface_row.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/math/so3.h"
#include "tegata/sim/grasps.h"

namespace tegata::bench {
namespace {

constexpr std::uint64_t kSeed = 1;

Eigen::Vector3d some_way(Random& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal());
}

std::vector<SurfacePair> some_pairs(const PosedHand& posed, std::size_t count, Random& random) {
  constexpr double kNoise = 0.001, kAlong = 0.002;  // [m]
  constexpr double kDeviation = 0.004;              // [m], as HullTermOptions has it
  std::vector<SurfacePair> pairs;
  std::vector<std::uint32_t> vertices(posed.vertices().size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) vertices[i] = i;
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(vertices[i], vertices[i + random.index(vertices.size() - i)]);
    const std::uint32_t vertex = vertices[i];
    const Eigen::Vector3d& normal = posed.normals()[vertex];
    const Eigen::Vector3d way = some_way(random);
    pairs.push_back({vertex,
                     posed.vertices()[vertex] + kNoise * random.normal() * normal +
                         kAlong * (way - way.dot(normal) * normal),
                     normal, random.uniform(0.3, 1.0) / (kDeviation * kDeviation)});
  }
  return pairs;
}

// Damped Gauss-Newton with a fixed number of steps; `linearise` gives the equations of all frames.
template <typename Linearise>
FitEnd descend_so_often(const PairFit& fit, const Linearise& linearise) {
  const FrameEquations prior;
  const auto cost = [](const std::vector<FrameEquations>& frames) {
    double sum = 0.0;
    for (const FrameEquations& frame : frames) sum += frame.cost;
    return sum;
  };
  FitEnd end{fit.start};
  std::vector<FrameEquations> current(fit.frames.size()), ahead;
  linearise(end.estimate, current);
  double damping = 1e-4;
  for (int i = 0; i < fit.iterations; ++i) {
    const HandEstimate trial = advanced(end.estimate, ArrowSystem(current, prior).solve(damping));
    ahead.assign(fit.frames.size(), FrameEquations());
    linearise(trial, ahead);
    if (cost(ahead) < cost(current)) {
      end.estimate = trial;
      std::swap(current, ahead);
      damping *= 0.2;
      ++end.steps;
    } else {
      damping *= 8.0;
    }
  }
  return end;
}

FlatMotionAt motion_at(const PairFit& fit, const Rigid3d& start) {
  const auto moving = std::make_shared<SkinMotion>(fit.model);
  return [moving, start](const double* pose, const double* angles, FlatMotion& motion) {
    const Eigen::Vector3d turn(pose[0], pose[1], pose[2]);
    HandPose to;
    to.world_from_hand.rotation = so3_exp(turn) * start.rotation;
    to.world_from_hand.translation = start.translation + Eigen::Vector3d(pose[3], pose[4], pose[5]);
    to.angles = Eigen::Map<const JointAngles>(angles);
    moving->move_to(to);
    const Eigen::Vector3d& origin = moving->origin();
    for (int bone = 0; bone < kBoneCount; ++bone) {
      const auto place = static_cast<std::size_t>(bone);
      const SkinMotion::Bone& from =
          bone == 0 ? moving->palm() : moving->digit((place - 1) / 3).bones[1 + (place - 1) % 3];
      for (std::size_t k = 0; k < 3; ++k) {
        std::copy(from.turn[k].begin(), from.turn[k].end(), motion.bones[bone] + 4 * k);
        motion.bones[bone][4 * k + 3] = from.shift[k] + origin[static_cast<Eigen::Index>(k)];
      }
    }
    for (std::size_t angle = 0; angle < kAngleCount; ++angle) {
      const SkinMotion::Axis& axis = moving->digit(angle / 4).axes[angle % 4];
      for (std::size_t k = 0; k < 3; ++k) {
        motion.centers[angle][k] = axis.center[k] + origin[static_cast<Eigen::Index>(k)];
        motion.directions[angle][k] = axis.direction[k];
      }
    }
    Eigen::Map<Eigen::Vector3d>(motion.origin) = origin;
    // d exp(v) = cross(J dv) exp(v), with J = 1 + (1 - cos a) / a^2 [v] + (a - sin a) / a^3 [v]^2.
    const double a = turn.norm();
    const Eigen::Matrix3d across = cross_matrix(turn);
    const double first = a > 1e-4 ? (1.0 - std::cos(a)) / (a * a) : 0.5;
    const double second = a > 1e-4 ? (a - std::sin(a)) / (a * a * a) : 1.0 / 6.0;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(motion.turn) =
        Eigen::Matrix3d::Identity() + first * across + second * across * across;
  };
}

}  // namespace

PairFit make_pair_fit(std::size_t frame_count, std::size_t pairs_a_frame) {
  constexpr double kTurn = 0.15, kShift = 0.01, kBend = 0.1;  // [rad], [m], [rad]
  PairFit fit;
  fit.model = built_in_hand({}, Side::right, {.triangle_count = 6000});
  fit.rows = std::make_shared<const SkinRows>(fit.model);
  fit.iterations = 10;
  const JointAngles angles = make_grasp(fit.model, SimulatedGrasp::cylinder, kSeed).angles;
  Random random(kSeed);
  for (std::size_t f = 0; f < frame_count; ++f) {
    const double turn = 0.05 * static_cast<double>(f);
    const Rigid3d pose{so3_exp({0.4, 0.2 + turn, 0.1}), {0.1, -0.2 + 0.1 * turn, 0.8}};
    fit.frames.push_back(
        some_pairs(PosedHand(fit.model, {pose, angles}, fit.rows), pairs_a_frame, random));
    const Eigen::Quaterniond off = so3_exp(kTurn * some_way(random).normalized());
    fit.start.world_from_hand.push_back(
        {off * pose.rotation, pose.translation + kShift * some_way(random).normalized()});
  }
  for (int angle = 0; angle < kAngleCount; ++angle) {
    fit.start.angles[angle] = angles[angle] + kBend * random.normal();
  }
  return fit;
}

FlatFit flat_fit(const PairFit& fit) {
  FlatFit flat;
  flat.iterations = fit.iterations;
  flat.angles.assign(fit.start.angles.begin(), fit.start.angles.end());
  for (std::size_t f = 0; f < fit.frames.size(); ++f) {
    FlatFrame& frame = flat.frames.emplace_back();
    frame.motion_at = motion_at(fit, fit.start.world_from_hand[f]);
    for (std::size_t part = 0; part < kFlatParts; ++part) {
      for (const SurfacePair& pair : fit.frames[f]) {
        const std::size_t row = fit.rows->first_row(pair.vertex), lane = row % kRowLanes;
        if (fit.rows->part_of_row(row) != part) continue;
        const SkinRows::Block& block = fit.rows->blocks()[row / kRowLanes];
        FlatPair& to = frame.pairs.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          to.rest[k] = block.position[k][lane];
          to.normal[k] = pair.normal[static_cast<Eigen::Index>(k)];
        }
        for (std::size_t k = 0; k < 4; ++k) to.weights[k] = block.weights[k][lane];
        to.offset = pair.normal.dot(pair.point);
        to.root_weight = std::sqrt(pair.weight);
      }
      frame.part_end[part] = frame.pairs.size();
    }
  }
  return flat;
}

FitEnd run_pair_fit(const PairFit& fit) {
  std::vector<SurfacePairs> frames;
  frames.reserve(fit.frames.size());
  for (const std::vector<SurfacePair>& pairs : fit.frames) frames.emplace_back(*fit.rows, pairs);
  SkinMotion motion(fit.model);
  return descend_so_often(
      fit, [&](const HandEstimate& estimate, std::vector<FrameEquations>& equations) {
        for (std::size_t f = 0; f < frames.size(); ++f) {
          motion.move_to(estimate.pose(f));
          equations[f].cost = frames[f].add_to(equations[f], motion);
        }
      });
}

FitEnd run_plainly(const PairFit& fit) {
  return descend_so_often(
      fit, [&](const HandEstimate& estimate, std::vector<FrameEquations>& equations) {
        for (std::size_t f = 0; f < fit.frames.size(); ++f) {
          const PosedHand posed(fit.model, estimate.pose(f), fit.rows);
          for (const SurfacePair& pair : fit.frames[f]) {
            HandRow row;
            add_vertex_row(posed, pair.vertex, pair.normal, row);
            const double residual = pair.normal.dot(posed.vertices()[pair.vertex] - pair.point);
            equations[f].add(residual, row, pair.weight, 0.5 * pair.weight * residual * residual);
          }
        }
      });
}

double cost_of(const PairFit& fit, const HandEstimate& estimate) {
  double cost = 0.0;
  for (std::size_t f = 0; f < fit.frames.size(); ++f) {
    const PosedHand posed(fit.model, estimate.pose(f), fit.rows);
    for (const SurfacePair& pair : fit.frames[f]) {
      const double residual = pair.normal.dot(posed.vertices()[pair.vertex] - pair.point);
      cost += 0.5 * pair.weight * residual * residual;
    }
  }
  return cost;
}

}  // namespace tegata::bench
