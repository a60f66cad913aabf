// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/normal_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tegata/base/random.h"

namespace tegata {
namespace {

std::vector<FrameEquations> random_frames(std::size_t count) {
  Random random(5);
  std::vector<FrameEquations> frames(count);
  for (FrameEquations& frame : frames) {
    for (int i = 0; i < 60; ++i) {
      ParameterRow row;
      for (int k = 0; k < kHandParameterCount; ++k) row[k] = random.normal();
      const double residual = random.normal();
      frame.add(residual, row, random.uniform(0.1, 1.0), residual * residual);
    }
  }
  return frames;
}

// The plain way: one dense matrix of all frames' poses and the shared angles.
Eigen::MatrixXd dense_hessian(const std::vector<FrameEquations>& frames,
                              Eigen::VectorXd& gradient) {
  const Eigen::Index poses = kPoseParameterCount * static_cast<Eigen::Index>(frames.size());
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(poses + kAngleCount, poses + kAngleCount);
  gradient = Eigen::VectorXd::Zero(poses + kAngleCount);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    std::vector<Eigen::Index> where;
    for (int i = 0; i < kPoseParameterCount; ++i) {
      where.push_back(kPoseParameterCount * static_cast<Eigen::Index>(f) + i);
    }
    for (int i = 0; i < kAngleCount; ++i) where.push_back(poses + i);
    for (int i = 0; i < kHandParameterCount; ++i) {
      gradient[where[static_cast<std::size_t>(i)]] += frames[f].gradient[i];
      for (int j = 0; j < kHandParameterCount; ++j) {
        hessian(where[static_cast<std::size_t>(i)], where[static_cast<std::size_t>(j)]) +=
            frames[f].hessian(i, j);
      }
    }
  }
  return hessian;
}

TEST(ArrowSystem, EliminationAgreesWithTheDenseSolution) {
  const std::vector<FrameEquations> frames = random_frames(4);
  const double damping = 0.01;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian = dense_hessian(frames, gradient);
  const Eigen::MatrixXd inverse = hessian.inverse();
  hessian.diagonal() *= 1.0 + damping;
  const Eigen::VectorXd expected = hessian.ldlt().solve(-gradient);

  const ArrowSystem system(frames, FrameEquations{});
  const ArrowStep step = system.solve(damping);
  EXPECT_LT((step.angles - expected.tail<kAngleCount>()).norm(), 1e-8);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const auto block =
        expected.segment<kPoseParameterCount>(kPoseParameterCount * static_cast<Eigen::Index>(f));
    EXPECT_LT((step.poses[f] - block).norm(), 1e-8);
  }
  const Eigen::MatrixXd covariance = inverse.bottomRightCorner<kAngleCount, kAngleCount>();
  EXPECT_LT((system.angle_covariance() - covariance).norm(), 1e-8 * covariance.norm() + 1e-9);
}

TEST(ArrowSystem, AParameterThatNothingIsKnownOfStaysWhereItIs) {
  std::vector<FrameEquations> frames = random_frames(1);
  frames[0].hessian.row(10).setZero();
  frames[0].hessian.col(10).setZero();
  frames[0].gradient[10] = 0.0;
  const ArrowStep step = ArrowSystem(frames, FrameEquations{}).solve(1e-3);
  EXPECT_TRUE(step.angles.allFinite());
  EXPECT_NEAR(step.angles[10 - kPoseParameterCount], 0.0, 1e-9);
}

}  // namespace
}  // namespace tegata
