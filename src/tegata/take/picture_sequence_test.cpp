// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/picture_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tegata {
namespace {

TEST(NaturalLess, NumbersAreComparedAsNumbers) {
  EXPECT_TRUE(natural_less("a2", "a10"));
  EXPECT_FALSE(natural_less("a10", "a2"));
  EXPECT_TRUE(natural_less("2_10", "10_2"));
  EXPECT_TRUE(natural_less("99999999999999999999998", "99999999999999999999999"));
  EXPECT_TRUE(natural_less("a", "a0"));
  EXPECT_TRUE(natural_less("a1b", "a1c"));
}

TEST(NaturalLess, IsAStrictOrderWithLeadingZeros) {
  const std::vector<std::string> names = {"",   "0",   "00", "1", "01",  "001",
                                          "1a", "01a", "1b", "a", "a01", "a1"};
  for (const std::string& a : names) {
    EXPECT_FALSE(natural_less(a, a)) << a;
    for (const std::string& b : names) {
      EXPECT_EQ(natural_less(a, b), a != b && !natural_less(b, a)) << a << " " << b;
      for (const std::string& c : names) {
        if (natural_less(a, b) && natural_less(b, c)) {
          EXPECT_TRUE(natural_less(a, c)) << a << " " << b << " " << c;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tegata
