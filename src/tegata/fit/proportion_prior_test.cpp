// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/proportion_prior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

constexpr double kTail = 10.0;

const Eigen::VectorXd& deviation() {
  static const Eigen::VectorXd values = Eigen::Vector4d(0.012, 0.05, 0.08, 0.03);
  return values;
}

/// Off by these numbers of standard deviations.
Eigen::VectorXd off(double a, double b, double c, double d) {
  return Eigen::Vector4d(a, b, c, d).cwiseProduct(deviation());
}

TEST(ProportionPrior, GradientIsTheDerivativeOfTheCost) {
  for (const Eigen::VectorXd& at : {off(0.3, -0.2, 0.1, 0.4), off(5.0, -2.0, 0.0, 7.0)}) {
    const PriorCost heavy = heavy_tailed_prior(at, deviation(), kTail);
    const PriorCost normal = normal_prior(at, deviation());
    const auto costs = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      return Eigen::Vector2d(heavy_tailed_prior(x, deviation(), kTail).cost,
                             normal_prior(x, deviation()).cost);
    };
    const Eigen::MatrixXd numeric = finite_difference_jacobian(costs, at);
    EXPECT_LT((heavy.gradient - numeric.row(0).transpose()).norm(), 1e-5 * heavy.gradient.norm());
    EXPECT_LT((normal.gradient - numeric.row(1).transpose()).norm(), 1e-5 * normal.gradient.norm());
  }
}

TEST(ProportionPrior, NearTheMeanTheHeavyTailIsNone) {
  const Eigen::VectorXd near = off(0.02, -0.01, 0.03, 0.01);
  const PriorCost heavy = heavy_tailed_prior(near, deviation(), kTail);
  const PriorCost normal = normal_prior(near, deviation());
  EXPECT_NEAR(heavy.cost / normal.cost, 1.0, 1e-3);
  EXPECT_LT((heavy.precision - normal.precision).norm(), 1e-3 * normal.precision.norm());
}

// Squares taken for lengths, or lengths for squares, would let ordinary hands go or hold others.
TEST(ProportionPrior, WhatIsFarOffIsHeldAsByWiderDeviations) {
  const Eigen::VectorXd far = off(3.0, -4.0, 2.0, 1.0);  // 30 squared deviations
  const PriorCost heavy = heavy_tailed_prior(far, deviation(), kTail);
  const PriorCost wide = normal_prior(far, 2.0 * deviation());  // sqrt(1 + 30 / 10)
  EXPECT_LT((heavy.precision - wide.precision).norm(), 1e-9 * wide.precision.norm());
  EXPECT_LT((heavy.gradient - wide.gradient).norm(), 1e-9 * wide.gradient.norm());
  EXPECT_NEAR(heavy.cost, 5.0 * std::log(4.0), 1e-9);
}

}  // namespace
}  // namespace tegata
