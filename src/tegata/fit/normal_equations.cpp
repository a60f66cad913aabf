// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/normal_equations.h"

#include <Eigen/Cholesky>

namespace tegata {
namespace {

constexpr int kP = kPoseParameterCount;
using PoseMatrix = Eigen::Matrix<double, kP, kP>;
using PoseVector = Eigen::Matrix<double, kP, 1>;
using PoseCross = Eigen::Matrix<double, Eigen::Dynamic, kP, 0, ArrowSystem::kMostShared, kP>;

// Marquardt's damping scales with the diagonal; the floor keeps a parameter that nothing is known
// of from making the matrix singular.
template <typename Matrix>
Matrix damped(const Matrix& lower, double damping) {
  Matrix full = lower.template selfadjointView<Eigen::Lower>();
  const double floor = 1e-12 * full.diagonal().maxCoeff() + 1e-300;
  full.diagonal() += (damping * full.diagonal().array() + floor).matrix();
  return full;
}

PoseMatrix pose_block(const FrameEquations& frame, double damping) {
  return damped(PoseMatrix(frame.hessian.topLeftCorner<kP, kP>()), damping);
}

PoseCross cross_block(const FrameEquations& frame) {
  PoseCross cross(kAngleCount + frame.shape_cross.rows(), kP);
  cross << frame.hessian.bottomLeftCorner<kAngleCount, kP>(), frame.shape_cross.leftCols<kP>();
  return cross;
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
  shared_hessian_ = SharedMatrix::Zero(count, count);
  shared_gradient_ = SharedVector::Zero(count);
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
  Reduced left{damped(shared_hessian_, damping), -shared_gradient_};
  for (const FrameEquations& frame : frames_) {
    const Eigen::LDLT<PoseMatrix> pose(pose_block(frame, damping));
    const PoseCross cross = cross_block(frame);
    left.matrix.noalias() -= cross * pose.solve(cross.transpose());
    left.right_side.noalias() += cross * pose.solve(PoseVector(frame.gradient.head<kP>()));
  }
  return left;
}

ArrowStep ArrowSystem::completed(const SharedVector& shared, double damping) const {
  ArrowStep step;
  step.angles = shared.head<kAngleCount>();
  step.shape = shared.tail(shared.size() - kAngleCount);
  step.poses.reserve(frames_.size());
  for (const FrameEquations& frame : frames_) {
    const PoseVector known = -frame.gradient.head<kP>() - cross_block(frame).transpose() * shared;
    step.poses.push_back(pose_block(frame, damping).ldlt().solve(known));
  }
  return step;
}

ArrowStep ArrowSystem::solve(double damping) const {
  const Reduced left = reduced(damping);
  return completed(left.matrix.ldlt().solve(left.right_side), damping);
}

ArrowSystem::AngleMatrix ArrowSystem::angle_covariance() const {
  const SharedMatrix matrix = reduced(0.0).matrix;
  const SharedMatrix inverse =
      matrix.ldlt().solve(SharedMatrix::Identity(matrix.rows(), matrix.cols()));
  return inverse.topLeftCorner<kAngleCount, kAngleCount>();
}

}  // namespace tegata
