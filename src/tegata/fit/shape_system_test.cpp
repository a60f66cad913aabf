// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/shape_system.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tegata/base/random.h"

namespace tegata {
namespace {

constexpr int kShapes = 7;

GraspEquations random_grasp(std::size_t frames, Random& random) {
  GraspEquations grasp{std::vector<FrameEquations>(frames, FrameEquations(kShapes)),
                       FrameEquations{}};
  for (FrameEquations& frame : grasp.frames) {
    for (int i = 0; i < 80; ++i) {
      ParameterRow row;
      for (int k = 0; k < kHandParameterCount; ++k) row[k] = random.normal();
      ShapeRow shape(kShapes);
      for (int k = 0; k < kShapes; ++k) shape[k] = random.normal();
      frame.add(random.normal(), row, random.uniform(0.1, 1.0), 0.0, shape);
    }
  }
  return grasp;
}

/// One dense system: for each grasp the poses of its frames and its angles, at last the shape.
struct Dense {
  explicit Dense(const std::vector<GraspEquations>& grasps) {
    Eigen::Index count = kShapes;
    for (const GraspEquations& grasp : grasps) {
      count += kAngleCount + kPoseParameterCount * static_cast<Eigen::Index>(grasp.frames.size());
    }
    hessian = Eigen::MatrixXd::Zero(count, count);
    gradient = Eigen::VectorXd::Zero(count);
    Eigen::Index pose = 0;
    for (const GraspEquations& grasp : grasps) {
      const Eigen::Index angles =
          pose + kPoseParameterCount * static_cast<Eigen::Index>(grasp.frames.size());
      for (const FrameEquations& frame : grasp.frames) {
        add(frame, pose, angles);
        pose += kPoseParameterCount;
      }
      pose = angles + kAngleCount;
    }
  }

  void add(const FrameEquations& frame, Eigen::Index pose, Eigen::Index angles) {
    constexpr int kAll = kHandParameterCount + kShapes;
    Eigen::Matrix<double, kAll, kAll> block;
    block << ParameterMatrix(frame.hessian.selfadjointView<Eigen::Lower>()),
        frame.shape_cross.transpose(), frame.shape_cross, frame.shape_hessian;
    Eigen::Matrix<double, kAll, 1> right;
    right << frame.gradient, frame.shape_gradient;
    const auto where = [&](Eigen::Index i) {
      if (i < kPoseParameterCount) return pose + i;
      if (i < kHandParameterCount) return angles + i - kPoseParameterCount;
      return gradient.size() - kShapes + i - kHandParameterCount;
    };
    for (Eigen::Index i = 0; i < kAll; ++i) {
      gradient[where(i)] += right[i];
      for (Eigen::Index j = 0; j < kAll; ++j) hessian(where(i), where(j)) += block(i, j);
    }
  }

  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
};

TEST(ShapeSystem, EliminationAgreesWithTheDenseSolution) {
  Random random(3);
  const std::vector<GraspEquations> grasps = {random_grasp(3, random), random_grasp(1, random)};
  const Eigen::VectorXd precision = Eigen::VectorXd::LinSpaced(kShapes, 5.0, 40.0);
  const Eigen::VectorXd prior_gradient = Eigen::VectorXd::LinSpaced(kShapes, -20.0, 30.0);
  Dense dense(grasps);
  dense.hessian.diagonal().tail(kShapes) += precision;
  dense.gradient.tail(kShapes) += prior_gradient;
  const Eigen::MatrixXd covariance = dense.hessian.inverse();
  const double damping = 0.02;
  dense.hessian.diagonal() *= 1.0 + damping;
  const Eigen::VectorXd expected = dense.hessian.ldlt().solve(-dense.gradient);

  const ShapeSystem system(grasps, precision, prior_gradient);
  const ShapeStep step = system.solve(damping);
  EXPECT_LT((step.shape - expected.tail(kShapes)).norm(), 1e-8);
  EXPECT_LT((system.covariance() - covariance.bottomRightCorner(kShapes, kShapes)).norm(), 1e-9);
  Eigen::Index at = 0;
  ASSERT_EQ(step.grasps.size(), grasps.size());
  for (const ArrowStep& grasp : step.grasps) {
    for (const auto& pose : grasp.poses) {
      EXPECT_LT((pose - expected.segment<kPoseParameterCount>(at)).norm(), 1e-8);
      at += kPoseParameterCount;
    }
    EXPECT_LT((grasp.angles - expected.segment<kAngleCount>(at)).norm(), 1e-8);
    EXPECT_LT((grasp.shape - step.shape).norm(), 1e-12);
    at += kAngleCount;
  }
}

}  // namespace
}  // namespace tegata
