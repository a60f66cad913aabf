// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "tegata/hand/skeleton.h"

namespace tegata {

using ParameterVector = Eigen::Matrix<double, kHandParameterCount, 1>;
using ParameterRow = Eigen::Matrix<double, 1, kHandParameterCount>;
using ParameterMatrix = Eigen::Matrix<double, kHandParameterCount, kHandParameterCount>;

/// The weighted normal equations of one frame's residuals by its pose (6) and the angles (20), and
/// the energy that they linearise. Residuals are in metres or radians over their own standard
/// deviation, so that all costs are plain numbers.
struct FrameEquations {
  ParameterMatrix hessian = ParameterMatrix::Zero();   ///< sum of w J^T J
  ParameterVector gradient = ParameterVector::Zero();  ///< sum of w J^T r
  double cost = 0.0;                                   ///< sum of rho

  /// Adds one residual with its weight rho'(r) / r and its cost rho(r).
  void add(double residual, const ParameterRow& jacobian, double weight, double residual_cost);
};

/// A step of all frames' poses and of the angles that they share.
struct ArrowStep {
  std::vector<Eigen::Matrix<double, kPoseParameterCount, 1>> poses;
  JointAngles angles = JointAngles::Zero();
};

/// Normal equations of many frames with one set of angles: a 6 x 6 block a frame and one shared
/// block, shaped like an arrow.
class ArrowSystem {
 public:
  using AngleMatrix = Eigen::Matrix<double, kAngleCount, kAngleCount>;

  /// `prior` holds what is known of the angles apart from any frame (only its angle block is used).
  ArrowSystem(std::span<const FrameEquations> frames, const FrameEquations& prior);

  /// Solves (H + damping diag(H)) step = -g by eliminating the frames one after the other; the
  /// dense matrix of all frames is never built.
  ArrowStep solve(double damping) const;

  /// The covariance of the angles with all poses free, up to the scale of the residuals.
  AngleMatrix angle_covariance() const;

 private:
  AngleMatrix reduced(double damping, JointAngles* right_side) const;

  std::span<const FrameEquations> frames_;
  AngleMatrix angle_hessian_;
  JointAngles angle_gradient_;
};

}  // namespace tegata
