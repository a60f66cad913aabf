// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/finite_difference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tegata {
namespace {

TEST(FiniteDifference, AgreesWithAKnownJacobian) {
  const auto function = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd{{std::sin(x[0]) * x[1], x[0] * x[0], x[1]}};
  };
  const Eigen::VectorXd x{{0.7, -1.3}};
  Eigen::MatrixXd expected(3, 2);
  expected << std::cos(x[0]) * x[1], std::sin(x[0]), 2.0 * x[0], 0.0, 0.0, 1.0;
  EXPECT_LT((finite_difference_jacobian(function, x) - expected).norm(), 1e-8);
}

}  // namespace
}  // namespace tegata
