// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>

namespace tegata {

// A tbb::task_arena of so many threads would say the same. But each one that is made takes a tenth
// of a millisecond and keeps 7 kB until oneTBB's workers happen to look at it (its issue 967), and
// a frame of a take makes two dozen. So as many loops run side by side, each of which takes the
// next index.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  const int cores = tbb::this_task_arena::max_concurrency();
  const int most = threads > 0 ? std::min(threads, cores) : cores;
  std::atomic<std::size_t> next = 0;
  const auto loop = [&](std::size_t) {
    for (std::size_t i = next++; i < count; i = next++) {
      if (tbb::is_current_task_group_canceling()) return;
      body(i);
    }
  };
  // Isolated: who waits for the last of these does not begin with another of the caller's tasks
  // meanwhile, which may take long and may want what the caller has locked.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(std::size_t{0}, std::min(count, static_cast<std::size_t>(most)), loop,
                      tbb::simple_partitioner{});
  });
}

}  // namespace tegata
