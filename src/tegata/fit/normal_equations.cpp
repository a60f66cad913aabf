// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/normal_equations.h"

#include <Eigen/Cholesky>

namespace tegata {
namespace {

constexpr int kP = kPoseParameterCount;
using PoseMatrix = Eigen::Matrix<double, kP, kP>;
using PoseVector = Eigen::Matrix<double, kP, 1>;
using CrossMatrix = Eigen::Matrix<double, kAngleCount, kP>;

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

CrossMatrix cross_block(const FrameEquations& frame) {
  return frame.hessian.bottomLeftCorner<kAngleCount, kP>();
}

}  // namespace

void FrameEquations::add(double residual, const ParameterRow& jacobian, double weight,
                         double residual_cost) {
  hessian.noalias() += (weight * jacobian.transpose()) * jacobian;
  gradient.noalias() += (weight * residual) * jacobian.transpose();
  cost += residual_cost;
}

ArrowSystem::ArrowSystem(std::span<const FrameEquations> frames, const FrameEquations& prior)
    : frames_(frames),
      angle_hessian_(prior.hessian.bottomRightCorner<kAngleCount, kAngleCount>()),
      angle_gradient_(prior.gradient.tail<kAngleCount>()) {
  for (const FrameEquations& frame : frames) {
    angle_hessian_ += frame.hessian.bottomRightCorner<kAngleCount, kAngleCount>();
    angle_gradient_ += frame.gradient.tail<kAngleCount>();
  }
}

ArrowSystem::AngleMatrix ArrowSystem::reduced(double damping, JointAngles* right_side) const {
  AngleMatrix matrix = damped(angle_hessian_, damping);
  if (right_side != nullptr) *right_side = -angle_gradient_;
  for (const FrameEquations& frame : frames_) {
    const Eigen::LDLT<PoseMatrix> pose(pose_block(frame, damping));
    const CrossMatrix cross = cross_block(frame);
    matrix.noalias() -= cross * pose.solve(cross.transpose());
    if (right_side != nullptr) {
      right_side->noalias() += cross * pose.solve(PoseVector(frame.gradient.head<kP>()));
    }
  }
  return matrix;
}

ArrowStep ArrowSystem::solve(double damping) const {
  ArrowStep step;
  JointAngles right_side;
  const AngleMatrix matrix = reduced(damping, &right_side);
  step.angles = matrix.ldlt().solve(right_side);
  step.poses.reserve(frames_.size());
  for (const FrameEquations& frame : frames_) {
    const PoseVector known =
        -frame.gradient.head<kP>() - cross_block(frame).transpose() * step.angles;
    step.poses.push_back(pose_block(frame, damping).ldlt().solve(known));
  }
  return step;
}

ArrowSystem::AngleMatrix ArrowSystem::angle_covariance() const {
  return reduced(0.0, nullptr).ldlt().solve(AngleMatrix::Identity());
}

}  // namespace tegata
