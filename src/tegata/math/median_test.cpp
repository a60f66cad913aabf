// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/median.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

TEST(Median, IsInTheMiddleWhateverTheOrder) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({5.0}), 5.0);
}

TEST(Median, OfAnEvenNumberIsTheUpperOfTheTwo) { EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 3.0); }

}  // namespace
}  // namespace tegata
