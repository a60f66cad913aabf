// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/parallel.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>
#include <vector>

#include "tegata/base/error.h"

namespace tegata {
namespace {

std::size_t resident_bytes() {
  std::size_t all_pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> all_pages >> resident_pages;
  return resident_pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

TEST(ParallelFor, VisitsEveryIndexOnce) {
  for (const int threads : {0, 1, 2, 5}) {
    std::vector<std::atomic<int>> visits(1000);
    parallel_for(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    for (const auto& count : visits) ASSERT_EQ(count.load(), 1) << threads << " threads";
  }
}

TEST(ParallelFor, NeverHasMoreIndicesInHandThanThreads) {
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 6);
  tbb::task_arena arena(6);  // more than this machine may have
  for (const int threads : {1, 2, 3}) {
    std::atomic<int> inside = 0, most = 0;
    const auto body = [&](std::size_t) {
      const int now = ++inside;
      for (int before = most; now > before && !most.compare_exchange_weak(before, now);) {
      }
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      --inside;
    };
    arena.execute([&] { parallel_for(200, threads, body); });
    EXPECT_LE(most.load(), threads);
  }
}

TEST(ParallelFor, WhoCallsItFromATaskIsNotGivenAnotherMeanwhile) {
  // The caller may hold a lock, or a frame of a take in memory.
  static thread_local int depth = 0;
  std::atomic<int> nested = 0;
  const auto task = [&](std::size_t) {
    if (++depth > 1) ++nested;
    parallel_for(4, 0,
                 [](std::size_t) { std::this_thread::sleep_for(std::chrono::microseconds(50)); });
    --depth;
  };
  // With two threads nothing is left to be given.
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 6);
  tbb::task_arena(6).execute([&] {
    tbb::parallel_for(std::size_t{0}, std::size_t{300}, task, tbb::simple_partitioner{});
  });
  EXPECT_EQ(nested.load(), 0);
}

TEST(ParallelFor, KeepsNoMemoryOfLoopsThatAreDone) {
  const auto loops = [](int count) {
    for (int i = 0; i < count; ++i) parallel_for(8, 2, [](std::size_t) {});
  };
  loops(100);
  const std::size_t before = resident_bytes();
  loops(2000);
  EXPECT_LT(resident_bytes(), before + 5'000'000U) << "an arena for each keeps 7 kB";
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
