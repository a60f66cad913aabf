// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/shape_system.h"

#include <Eigen/Cholesky>

namespace tegata {
namespace {

constexpr int kA = kAngleCount;

/// A grasp with its angles eliminated.
struct Eliminated {
  explicit Eliminated(ArrowSystem::Reduced reduced)
      : left(std::move(reduced)),
        angles(left.matrix.topLeftCorner<kA, kA>()),
        cross(left.matrix.bottomLeftCorner(left.matrix.rows() - kA, kA)) {}

  Eigen::MatrixXd matrix() const {
    return left.matrix.bottomRightCorner(cross.rows(), cross.rows()) -
           cross * angles.solve(cross.transpose());
  }
  Eigen::VectorXd right_side() const {
    return left.right_side.tail(cross.rows()) -
           cross * angles.solve(JointAngles(left.right_side.head<kA>()));
  }
  ArrowSystem::SharedVector completed(const Eigen::VectorXd& shape) const {
    ArrowSystem::SharedVector shared(left.right_side.size());
    shared << angles.solve(JointAngles(left.right_side.head<kA>() - cross.transpose() * shape)),
        shape;
    return shared;
  }

  ArrowSystem::Reduced left;
  Eigen::LDLT<ArrowSystem::AngleMatrix> angles;
  Eigen::Matrix<double, Eigen::Dynamic, kA> cross;
};

}  // namespace

ShapeSystem::ShapeSystem(const std::vector<GraspEquations>& grasps,
                         const Eigen::VectorXd& prior_precision,
                         const Eigen::VectorXd& prior_gradient)
    : prior_precision_(prior_precision), prior_gradient_(prior_gradient) {
  grasps_.reserve(grasps.size());
  for (const GraspEquations& grasp : grasps) grasps_.emplace_back(grasp.frames, grasp.prior);
}

ShapeStep ShapeSystem::solve(double damping) const {
  Eigen::MatrixXd matrix = ((1.0 + damping) * prior_precision_).asDiagonal();
  Eigen::VectorXd right_side = -prior_gradient_;
  std::vector<Eliminated> eliminated;
  eliminated.reserve(grasps_.size());
  for (const ArrowSystem& grasp : grasps_) {
    eliminated.emplace_back(grasp.reduced(damping));
    matrix += eliminated.back().matrix();
    right_side += eliminated.back().right_side();
  }
  ShapeStep step;
  step.shape = matrix.ldlt().solve(right_side);
  for (std::size_t g = 0; g < grasps_.size(); ++g) {
    step.grasps.push_back(grasps_[g].completed(eliminated[g].completed(step.shape), damping));
  }
  return step;
}

Eigen::MatrixXd ShapeSystem::covariance() const {
  Eigen::MatrixXd matrix = prior_precision_.asDiagonal();
  for (const ArrowSystem& grasp : grasps_) matrix += Eliminated(grasp.reduced(0.0)).matrix();
  return matrix.ldlt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

}  // namespace tegata
