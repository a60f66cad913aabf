// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/robust_kernel.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

TEST(LorentzianKernel, WeightIsTheSlopeOfTheCostOverTheDistance) {
  const LorentzianKernel kernel(0.01);
  for (const double distance : {0.001, 0.01, 0.05}) {
    const double step = 1e-6;
    const double slope = (kernel.cost(distance + step) - kernel.cost(distance - step)) / (2 * step);
    EXPECT_NEAR(kernel.weight(distance), slope / distance, 1e-6);
  }
}

TEST(LorentzianKernel, TakesDistancesNotSquares) {
  // At z = sigma sqrt(2) the weight is one half; a kernel fed with squares would answer otherwise.
  EXPECT_NEAR(LorentzianKernel(2.0).weight(2.0 * std::sqrt(2.0)), 0.5, 1e-12);
}

TEST(LorentzianKernel, ScalesWithItsUnit) {
  EXPECT_NEAR(LorentzianKernel(0.01).cost(0.02) * 100.0, LorentzianKernel(0.1).cost(0.2), 1e-12);
}

}  // namespace
}  // namespace tegata
