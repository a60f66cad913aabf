// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/random.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

TEST(Random, SameSeedGivesSameNumbers) {
  Random a(7), b(7), c(8);
  const double first = a.uniform();
  EXPECT_EQ(first, b.uniform());
  EXPECT_NE(first, c.uniform());
}

TEST(Random, NormalHasItsMeanAndSpread) {
  Random random(1);
  const int count = 20000;
  double sum = 0.0, sum_of_squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal(3.0, 2.0);
    sum += x;
    sum_of_squares += (x - 3.0) * (x - 3.0);
  }
  EXPECT_NEAR(sum / count, 3.0, 0.05);
  EXPECT_NEAR(sum_of_squares / count, 4.0, 0.15);
}

TEST(Random, UniformStaysInItsRange) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(-1.0, 2.0);
    ASSERT_GE(x, -1.0);
    ASSERT_LT(x, 2.0);
    ASSERT_LT(random.index(3), 3u);
  }
}

}  // namespace
}  // namespace tegata
