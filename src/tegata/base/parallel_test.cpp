// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "tegata/base/error.h"

namespace tegata {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
  for (const int threads : {0, 1, 2, 5}) {
    std::vector<std::atomic<int>> visits(1000);
    parallel_for(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    for (const auto& count : visits) ASSERT_EQ(count.load(), 1) << threads << " threads";
  }
}

TEST(ParallelFor, PassesOnTheErrorOfABody) {
  const auto run = [](int threads) {
    parallel_for(100, threads, [](std::size_t i) {
      if (i == 50) throw Error("body ", i, " failed");
    });
  };
  EXPECT_THROW(run(1), Error);
  EXPECT_THROW(run(2), Error);
}

}  // namespace
}  // namespace tegata
