// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/normal_equations.h"

#include <Eigen/Cholesky>

#include "tegata/fit/column_elimination.h"

namespace tegata {
namespace {

constexpr int kP = kPoseParameterCount;
using PoseVector = Eigen::Matrix<double, kP, 1>;
using SharedColumns = ColumnElimination<ArrowSystem::kMostShared, ArrowSystem::kMostShared + 1>;

// A frame's pose, eliminated: rows are pose, angles, shape and the gradient.
struct PoseColumns : ColumnElimination<kP, kP + ArrowSystem::kMostShared + 1> {
  PoseColumns(const FrameEquations& frame, double damping)
      : ColumnElimination(kHandParameterCount + frame.shape_gradient.size() + 1) {
    const Eigen::Index shape_count = frame.shape_gradient.size();
    for (int j = 0; j < kP; ++j) {
      auto to = column(j);
      to.head<kHandParameterCount>() = frame.hessian.col(j);
      if (shape_count > 0) to.segment(kHandParameterCount, shape_count) = frame.shape_cross.col(j);
      to[to.size() - 1] = frame.gradient[j];
    }
    damp(kP, damping);
    eliminate(kP);
  }
};

// What is left of a frame's step once the others' is known.
PoseVector pose_step(const PoseColumns& columns, const ArrowSystem::SharedVector& shared) {
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kP + ArrowSystem::kMostShared, 1> step(kP +
                                                                                     shared.size());
  step.tail(shared.size()) = shared;
  columns.substitute_back(step);
  return step.head<kP>();
}

ArrowStep step_of(const ArrowSystem::SharedVector& shared) {
  ArrowStep step;
  step.angles = shared.head<kAngleCount>();
  step.shape = shared.tail(shared.size() - kAngleCount);
  return step;
}

SharedColumns damped_columns(const ArrowSystem::SharedMatrix& hessian,
                             const ArrowSystem::SharedVector& gradient, double damping) {
  SharedColumns columns(gradient.size() + 1);
  const Eigen::Index shape_count = gradient.size() - kAngleCount;
  for (Eigen::Index j = 0; j < gradient.size(); ++j) {
    auto to = columns.column(j);
    to.head<kAngleCount>() = hessian.col(j).head<kAngleCount>();
    if (shape_count > 0) to.segment(kAngleCount, shape_count) = hessian.col(j).tail(shape_count);
    to[gradient.size()] = gradient[j];
  }
  columns.damp(gradient.size(), damping);
  return columns;
}

}  // namespace

FrameEquations::FrameEquations(int shape_count)
    : shape_hessian(Eigen::MatrixXd::Zero(shape_count, shape_count)),
      shape_cross(decltype(shape_cross)::Zero(shape_count, kHandParameterCount)),
      shape_gradient(Eigen::VectorXd::Zero(shape_count)) {}

void FrameEquations::add(double residual, const HandRow& row, double weight, double residual_cost,
                         const ShapeRow& by_shape) {
  constexpr int kA = kAnglesPerDigit;
  const PoseVector pose = row.values.head<kP>().transpose();
  const PoseVector weighted_pose = weight * pose;
  for (int column = 0; column < kP; ++column) {
    hessian.col(column).head<kP>() += pose[column] * weighted_pose;
  }
  gradient.head<kP>() += residual * weighted_pose;
  for (int digit = 0; digit < kDigitCount; ++digit) {
    if ((row.digits >> digit & 1U) == 0) continue;
    const int first = kP + kA * digit;
    const Eigen::Matrix<double, kA, 1> weighted = weight * row.values.segment<kA>(first);
    for (int column = 0; column < kP; ++column) {
      hessian.col(column).segment<kA>(first) += pose[column] * weighted;
    }
    gradient.segment<kA>(first) += residual * weighted;
    for (int other = 0; other <= digit; ++other) {
      if ((row.digits >> other & 1U) == 0) continue;
      const int other_first = kP + kA * other;
      for (int column = other_first; column < other_first + kA; ++column) {
        hessian.col(column).segment<kA>(first) += row.values[column] * weighted;
      }
    }
  }
  cost += residual_cost;
  if (by_shape.size() > 0) add_shape(residual, row, weight, by_shape);
}

void FrameEquations::add_shape(double residual, const HandRow& row, double weight,
                               const ShapeRow& by_shape) {
  shape_hessian.noalias() += (weight * by_shape.transpose()) * by_shape;
  shape_cross.noalias() += (weight * by_shape.transpose()) * row.values;
  shape_gradient.noalias() += (weight * residual) * by_shape.transpose();
}

ArrowSystem::ArrowSystem(std::span<const FrameEquations> frames, const FrameEquations& prior)
    : frames_(frames) {
  const Eigen::Index shape_count = frames.empty() ? 0 : frames.front().shape_gradient.size();
  const Eigen::Index count = kAngleCount + shape_count;
  shared_hessian_.resize(count, count);
  shared_gradient_.resize(count);
  if (shape_count > 0) {
    shared_hessian_.setZero();
    shared_gradient_.setZero();
  }
  shared_hessian_.topLeftCorner<kAngleCount, kAngleCount>() =
      prior.hessian.bottomRightCorner<kAngleCount, kAngleCount>();
  shared_gradient_.head<kAngleCount>() = prior.gradient.tail<kAngleCount>();
  for (const FrameEquations& frame : frames) {
    shared_hessian_.topLeftCorner<kAngleCount, kAngleCount>() +=
        frame.hessian.bottomRightCorner<kAngleCount, kAngleCount>();
    shared_gradient_.head<kAngleCount>() += frame.gradient.tail<kAngleCount>();
    if (shape_count == 0) continue;
    shared_hessian_.bottomLeftCorner(shape_count, kAngleCount) +=
        frame.shape_cross.rightCols<kAngleCount>();
    shared_hessian_.bottomRightCorner(shape_count, shape_count) += frame.shape_hessian;
    shared_gradient_.tail(shape_count) += frame.shape_gradient;
  }
}

ArrowSystem::Reduced ArrowSystem::reduced(double damping) const {
  const Eigen::Index count = shared_gradient_.size();
  SharedColumns columns = damped_columns(shared_hessian_, shared_gradient_, damping);
  for (const FrameEquations& frame : frames_) {
    PoseColumns(frame, damping).subtract_from(columns, count, kP);
  }
  Reduced left{SharedMatrix(count, count), SharedVector(count)};
  for (Eigen::Index j = 0; j < count; ++j) {
    left.matrix.col(j) = columns.column(j).head(count);
    left.right_side[j] = -columns.column(j)[count];
  }
  left.matrix.triangularView<Eigen::StrictlyUpper>() = left.matrix.transpose();
  return left;
}

ArrowStep ArrowSystem::completed(const SharedVector& shared, double damping) const {
  ArrowStep step = step_of(shared);
  step.poses.reserve(frames_.size());
  for (const FrameEquations& frame : frames_) {
    step.poses.push_back(pose_step(PoseColumns(frame, damping), shared));
  }
  return step;
}

ArrowStep ArrowSystem::solve(double damping) const {
  const Eigen::Index count = shared_gradient_.size();
  SharedColumns columns = damped_columns(shared_hessian_, shared_gradient_, damping);
  std::vector<PoseColumns> poses;
  poses.reserve(frames_.size());
  for (const FrameEquations& frame : frames_) {
    poses.emplace_back(frame, damping).subtract_from(columns, count, kP);
  }
  columns.eliminate(count);
  SharedVector shared = SharedVector::Zero(count);
  columns.substitute_back(shared);
  ArrowStep step = step_of(shared);
  step.poses.reserve(frames_.size());
  for (const PoseColumns& pose : poses) step.poses.push_back(pose_step(pose, shared));
  return step;
}

ArrowSystem::AngleMatrix ArrowSystem::angle_covariance() const {
  const SharedMatrix matrix = reduced(0.0).matrix;
  const SharedMatrix inverse =
      matrix.ldlt().solve(SharedMatrix::Identity(matrix.rows(), matrix.cols()));
  return inverse.topLeftCorner<kAngleCount, kAngleCount>();
}

}  // namespace tegata
