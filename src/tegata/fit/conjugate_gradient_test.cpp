// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/conjugate_gradient.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

// A long valley, axes 100 to 1, with its floor at (1, 2, 3) and maybe a wall before it.
struct Valley {
  Eigen::Vector3d axes = {100.0, 10.0, 1.0};
  Eigen::Vector3d upper = {9.0, 9.0, 9.0};

  EnergySlope evaluate(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d off = x - Eigen::Vector3d(1.0, 2.0, 3.0);
    Eigen::VectorXd gradient = axes.cwiseProduct(off);
    for (int k = 0; k < 3; ++k) {
      if (x[k] >= upper[k] && gradient[k] < 0.0) gradient[k] = 0.0;
    }
    return {0.5 * off.dot(axes.cwiseProduct(off)), gradient};
  }
  Eigen::Vector3d advanced(const Eigen::Vector3d& x, const Eigen::VectorXd& step) const {
    return (x + step).cwiseMin(upper);
  }
};

constexpr ConjugateGradientOptions kThorough = {
    .most_iterations = 40, .energy_tolerance = 1e-14, .first_step = 0.1, .longest_step = 10.0};

TEST(ConjugateGradient, FindsTheFloorOfALongValley) {
  Eigen::Vector3d x(0.0, 0.0, 0.0);
  const double energy = conjugate_gradient(Valley{}, kThorough, x);
  EXPECT_LT(energy, 1e-8);
  EXPECT_LT((x - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-4);
}

TEST(ConjugateGradient, NeedsFarFewerIterationsThanSteepestDescent) {
  Eigen::Vector3d x(0.0, 0.0, 0.0);
  ConjugateGradientOptions few = kThorough;
  few.most_iterations = 12;
  EXPECT_LT(conjugate_gradient(Valley{}, few, x), 1e-3);
  // Steepest descent with the best lengths shrinks the energy by (99 / 101)^2 at each iteration.
}

TEST(ConjugateGradient, StaysWithinBoundsAndGoesOnAlongThem) {
  Valley valley;
  valley.upper = {9.0, 9.0, 2.0};
  Eigen::Vector3d x(0.0, 0.0, 0.0);
  conjugate_gradient(valley, kThorough, x);
  EXPECT_LE(x[2], 2.0);
  EXPECT_LT((x - Eigen::Vector3d(1.0, 2.0, 2.0)).norm(), 1e-3);
}

TEST(ConjugateGradient, NeverRaisesTheEnergy) {
  const Valley valley;
  Eigen::Vector3d x(1.0, 2.0, 3.0);
  EXPECT_EQ(conjugate_gradient(valley, kThorough, x), 0.0);
  for (int most = 1; most < 8; ++most) {
    Eigen::Vector3d from(-3.0, 5.0, 8.0);
    const double before = valley.evaluate(from).energy;
    ConjugateGradientOptions options = kThorough;
    options.most_iterations = most;
    EXPECT_LT(conjugate_gradient(valley, options, from), before);
  }
}

}  // namespace
}  // namespace tegata
