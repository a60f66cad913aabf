// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tegata/hand/shape_parameters.h"
#include "tegata/hand/skeleton.h"

namespace tegata {

using ParameterVector = Eigen::Matrix<double, kHandParameterCount, 1>;
using ParameterRow = Eigen::Matrix<double, 1, kHandParameterCount>;
using ParameterMatrix = Eigen::Matrix<double, kHandParameterCount, kHandParameterCount>;
/// By the parameters of the hand's shape that are sought: none, its scale or all.
using ShapeRow = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kShapeParameterCount>;

inline constexpr int kAnglesPerDigit = 4;
/// Digits as bits, the thumb's the lowest.
using DigitSet = std::uint32_t;
inline constexpr DigitSet kAllDigits = (1U << kDigitCount) - 1U;

/// A residual's row by pose and angles, with the digits whose angles it depends on: of a point of
/// the surface mostly one or none, and what is zero is not multiplied.
struct HandRow {
  HandRow() : values(ParameterRow::Zero()) {}
  HandRow(const ParameterRow& row, DigitSet row_digits = kAllDigits)  // NOLINT: a row is one
      : values(row), digits(row_digits) {}

  ParameterRow values;
  DigitSet digits = 0;
};

/// The weighted normal equations of one frame's residuals by its pose (6) and the angles (20), and
/// the energy that they linearise; by the hand's shape as well, where that is sought. Residuals are
/// in metres or radians over their own standard deviation, so that all costs are plain numbers.
struct FrameEquations {
  /// Of so many shape parameters.
  explicit FrameEquations(int shape_count = 0);

  /// Sum of w J^T J, its lower half.
  ParameterMatrix hessian = ParameterMatrix::Zero();
  ParameterVector gradient = ParameterVector::Zero();                      ///< sum of w J^T r
  double cost = 0.0;                                                       ///< sum of rho
  Eigen::MatrixXd shape_hessian;                                           ///< shape by shape
  Eigen::Matrix<double, Eigen::Dynamic, kHandParameterCount> shape_cross;  ///< shape by the others
  Eigen::VectorXd shape_gradient;

  /// Adds one residual with its weight rho'(r) / r and its cost rho(r). Its row by the shape has
  /// one entry a shape parameter, or none where it does not depend on them.
  void add(double residual, const HandRow& row, double weight, double residual_cost,
           const ShapeRow& by_shape = {});
  /// Of that only what concerns the shape.
  void add_shape(double residual, const HandRow& row, double weight, const ShapeRow& by_shape);
};

/// A step of all frames' poses and of the angles and the shape that they share.
struct ArrowStep {
  std::vector<Eigen::Matrix<double, kPoseParameterCount, 1>> poses;
  JointAngles angles = JointAngles::Zero();
  Eigen::VectorXd shape;
};

/// Normal equations of many frames with one set of angles and one shape: a 6 x 6 block a frame and
/// one shared block, shaped like an arrow.
class ArrowSystem {
 public:
  using AngleMatrix = Eigen::Matrix<double, kAngleCount, kAngleCount>;
  /// Of angles, then shape parameters.
  static constexpr int kMostShared = kAngleCount + kShapeParameterCount;
  using SharedMatrix =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostShared, kMostShared>;
  using SharedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostShared, 1>;
  struct Reduced {
    SharedMatrix matrix;
    SharedVector right_side;
  };

  /// `prior` holds what is known of the angles apart from any frame (only its angle block is used).
  /// Frames must be of one count of shape parameters.
  ArrowSystem(std::span<const FrameEquations> frames, const FrameEquations& prior);

  /// Solves (H + damping diag(H)) step = -g by eliminating the frames one after the other; the
  /// dense matrix of all frames is never built.
  ArrowStep solve(double damping) const;
  /// What is left for angles and shape once the poses are eliminated.
  Reduced reduced(double damping) const;
  /// The poses' step that goes with one of the angles and the shape.
  ArrowStep completed(const SharedVector& shared, double damping) const;

  /// The covariance of the angles with all poses (and the shape) free, up to the scale of the
  /// residuals.
  AngleMatrix angle_covariance() const;

 private:
  std::span<const FrameEquations> frames_;
  SharedMatrix shared_hessian_;  ///< its lower half
  SharedVector shared_gradient_;
};

}  // namespace tegata
