// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/normal_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tegata/base/random.h"

namespace tegata {
namespace {

std::vector<FrameEquations> random_frames(std::size_t count, int shape_count = 0) {
  Random random(5);
  std::vector<FrameEquations> frames(count, FrameEquations(shape_count));
  for (FrameEquations& frame : frames) {
    for (int i = 0; i < 60; ++i) {
      ParameterRow row;
      for (int k = 0; k < kHandParameterCount; ++k) row[k] = random.normal();
      ShapeRow shape(shape_count);
      for (int k = 0; k < shape_count; ++k) shape[k] = random.normal();
      const double residual = random.normal();
      frame.add(residual, row, random.uniform(0.1, 1.0), residual * residual, shape);
    }
  }
  return frames;
}

/// The plain way: one dense matrix of all frames' poses, the shared angles and the shape.
struct Dense {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
};

Dense dense_system(const std::vector<FrameEquations>& frames) {
  const Eigen::Index shape_count = frames.front().shape_gradient.size();
  const Eigen::Index poses = kPoseParameterCount * static_cast<Eigen::Index>(frames.size());
  const Eigen::Index count = poses + kAngleCount + shape_count;
  Dense dense{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const FrameEquations& frame = frames[f];
    Eigen::MatrixXd hessian(kHandParameterCount + shape_count, kHandParameterCount + shape_count);
    hessian << ParameterMatrix(frame.hessian.selfadjointView<Eigen::Lower>()),
        frame.shape_cross.transpose(), frame.shape_cross, frame.shape_hessian;
    Eigen::VectorXd gradient(kHandParameterCount + shape_count);
    gradient << frame.gradient, frame.shape_gradient;
    const auto where = [&](Eigen::Index i) {
      const Eigen::Index first = kPoseParameterCount * static_cast<Eigen::Index>(f);
      return i < kPoseParameterCount ? first + i : poses + i - kPoseParameterCount;
    };
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      dense.gradient[where(i)] += gradient[i];
      for (Eigen::Index j = 0; j < gradient.size(); ++j) {
        dense.hessian(where(i), where(j)) += hessian(i, j);
      }
    }
  }
  return dense;
}

void expect_dense_solution(const std::vector<FrameEquations>& frames) {
  const double damping = 0.01;
  Dense dense = dense_system(frames);
  const Eigen::Index shape_count = frames.front().shape_gradient.size();
  const Eigen::Index angles = dense.gradient.size() - kAngleCount - shape_count;
  const Eigen::MatrixXd inverse = dense.hessian.inverse();
  dense.hessian.diagonal() *= 1.0 + damping;
  const Eigen::VectorXd expected = dense.hessian.ldlt().solve(-dense.gradient);

  const ArrowSystem system(frames, FrameEquations{});
  const ArrowStep step = system.solve(damping);
  EXPECT_LT((step.angles - expected.segment<kAngleCount>(angles)).norm(), 1e-8);
  EXPECT_LT((step.shape - expected.tail(shape_count)).norm(), 1e-8);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const auto block =
        expected.segment<kPoseParameterCount>(kPoseParameterCount * static_cast<Eigen::Index>(f));
    EXPECT_LT((step.poses[f] - block).norm(), 1e-8);
  }
  const Eigen::MatrixXd covariance = inverse.block<kAngleCount, kAngleCount>(angles, angles);
  EXPECT_LT((system.angle_covariance() - covariance).norm(), 1e-8 * covariance.norm() + 1e-9);
}

TEST(FrameEquations, DigitsThatARowDoesNotDependOnChangeNothing) {
  Random random(5);
  FrameEquations sparse, dense;
  for (const DigitSet digits : {0U, 1U, 4U, 16U, 10U}) {
    HandRow row;
    row.digits = digits;
    for (int k = 0; k < kHandParameterCount; ++k) {
      const int digit = (k - kPoseParameterCount) / kAnglesPerDigit;
      if (k < kPoseParameterCount || (digits >> digit & 1U) != 0) {
        row.values[k] = random.uniform(-1.0, 1.0);
      }
    }
    sparse.add(0.7, row, 2.0, 0.1);
    dense.add(0.7, HandRow(row.values), 2.0, 0.1);
  }
  EXPECT_EQ(sparse.hessian, dense.hessian);
  EXPECT_EQ(sparse.gradient, dense.gradient);
  EXPECT_EQ(sparse.cost, dense.cost);
}

TEST(ArrowSystem, EliminationAgreesWithTheDenseSolution) {
  expect_dense_solution(random_frames(4));
}

TEST(ArrowSystem, EliminationAgreesWithTheDenseSolutionWithAShape) {
  expect_dense_solution(random_frames(4, 1));
  expect_dense_solution(random_frames(4, kShapeParameterCount));
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
