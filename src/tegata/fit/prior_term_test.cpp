// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/prior_term.h"

#include <gtest/gtest.h>

#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

TEST(PriorTerm, GradientIsTheFiniteDifferenceOfTheEnergy) {
  PriorTermOptions options;
  options.previous = relaxed_angles();
  JointAngles angles = relaxed_angles();
  for (int k = 0; k < kAngleCount; ++k) angles[k] += 0.3 * (k % 3 - 1);
  angles[5] = angle_limits().upper[5] + 0.2;
  angles[7] = angle_limits().lower[7] - 0.1;
  const auto energy = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    FrameEquations equations;
    add_prior_term(x, options, 3, equations);
    return Eigen::VectorXd::Constant(1, equations.cost);
  };
  FrameEquations equations;
  add_prior_term(angles, options, 3, equations);
  const Eigen::MatrixXd expected = finite_difference_jacobian(energy, angles);
  EXPECT_LT((equations.gradient.tail<kAngleCount>().transpose() - expected).norm(), 1e-5);
  EXPECT_EQ(equations.gradient.head<kPoseParameterCount>().norm(), 0.0);
}

TEST(PriorTerm, LimitsPushBackFromEitherSideOnly) {
  const auto gradient_beyond = [](double off, int angle) {
    PriorTermOptions options;
    options.flexion_standard_deviation = options.abduction_standard_deviation = 1e6;
    options.coupling_standard_deviation = 1e6;
    JointAngles angles = relaxed_angles();
    angles[angle] =
        off > 0.0 ? angle_limits().upper[angle] + off : angle_limits().lower[angle] + off;
    FrameEquations equations;
    add_prior_term(angles, options, 3, equations);
    return equations.gradient[kPoseParameterCount + angle];
  };
  EXPECT_GT(gradient_beyond(0.1, 5), 1.0);
  EXPECT_LT(gradient_beyond(-0.1, 5), -1.0);
}

}  // namespace
}  // namespace tegata
