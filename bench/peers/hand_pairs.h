// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A hand drawn to planes, in flat arrays, for the peers that fit it. Each peer is compiled with
// flags of its own, so what they share is a copy each.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace tegata::bench {

inline constexpr int kFlatPose = 6, kFlatAngles = 20, kFlatParts = 6;  // five digits and the palm

/// What a pose does to the surface. Matrices row by row.
struct FlatMotion {
  double bones[16][12];  ///< from the rest surface to the world, 3 x 4
  double centers[20][3], directions[20][3];
  double origin[3];  ///< what the pose turns about
  double turn[9];    ///< the world's turn by the pose's first three parameters
};
/// Pose: a rotation vector and a shift from the start; angles as they are.
using FlatMotionAt = std::function<void(const double* pose, const double* angles, FlatMotion&)>;

/// A vertex that one digit or the palm alone moves, and its plane.
struct FlatPair {
  double rest[3], normal[3];
  double weights[4];   ///< of the palm and the digit's bones
  double offset;       ///< of the plane
  double root_weight;  ///< of the residual
};

struct FlatFrame {
  std::vector<FlatPair> pairs;       ///< by part
  std::size_t part_end[kFlatParts];  ///< where each part's pairs end
  FlatMotionAt motion_at;
};

struct FlatFit {
  std::vector<FlatFrame> frames;
  std::vector<double> angles;  ///< to start from
  int iterations = 0;
};

struct FitWork {
  std::function<std::size_t()> run;  ///< returns the bits of the cost
  std::function<double()> cost;      ///< at the end of the last run
  std::function<int()> steps;        ///< that lowered the cost in the last run
};

/// ceres::TinySolver, of the first frame.
FitWork tiny_solver_fit(const FlatFit& fit);

enum class CeresSolver { dense_qr, dense_normal_cholesky, sparse_normal_cholesky, sparse_schur };
/// One cost function a frame by its pose and all angles; `by_digit`: six a frame, each by the pose
/// and the angles of its digit. Derivatives in closed form.
FitWork ceres_fit(const FlatFit& fit, CeresSolver solver, bool by_digit);

namespace {

double flat_dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The residual; where `row` is given its derivatives by the pose and the digit's four angles.
inline double flat_residual(const FlatPair& pair, std::size_t part, const FlatMotion& motion,
                            double* row) {
  double point[3] = {0.0, 0.0, 0.0}, arms[4][3], moved[4][3];
  const double* n = pair.normal;
  const bool is_digit = part < 5;
  for (std::size_t i = 0; i < (is_digit ? 4u : 1u); ++i) {
    if (pair.weights[i] == 0.0) {
      moved[i][0] = moved[i][1] = moved[i][2] = 0.0;
      continue;
    }
    const double* bone = motion.bones[i == 0 ? 0 : 3 * part + i];
    for (int k = 0; k < 3; ++k) {
      moved[i][k] = pair.weights[i] * (flat_dot(bone + 4 * k, pair.rest) + bone[4 * k + 3]);
      point[k] += moved[i][k];
    }
  }
  const double root = pair.root_weight, residual = root * (flat_dot(n, point) - pair.offset);
  if (row == nullptr) return residual;

  const double arm[3] = {point[0] - motion.origin[0], point[1] - motion.origin[1],
                         point[2] - motion.origin[2]};
  const double turn[3] = {arm[1] * n[2] - arm[2] * n[1], arm[2] * n[0] - arm[0] * n[2],
                          arm[0] * n[1] - arm[1] * n[0]};
  for (int k = 0; k < 3; ++k) {
    row[k] = root * (turn[0] * motion.turn[k] + turn[1] * motion.turn[3 + k] +
                     turn[2] * motion.turn[6 + k]);
    row[3 + k] = root * n[k];
  }
  if (!is_digit) return residual;
  double weight = 0.0, sum[3] = {0.0, 0.0, 0.0};
  for (std::size_t i = 3; i > 0; --i) {
    weight += pair.weights[i];
    const double* center = motion.centers[4 * part + i];
    for (int k = 0; k < 3; ++k) {
      sum[k] += moved[i][k];
      arms[i][k] = sum[k] - weight * center[k];
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double* a = arms[i == 0 ? 1 : i];  // the first two angles share their centre
    const double lever[3] = {a[1] * n[2] - a[2] * n[1], a[2] * n[0] - a[0] * n[2],
                             a[0] * n[1] - a[1] * n[0]};
    row[6 + i] = root * flat_dot(motion.directions[4 * part + i], lever);
  }
  return residual;
}

}  // namespace
}  // namespace tegata::bench
