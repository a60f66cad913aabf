// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "rounds.h"

#include <algorithm>
#include <ctime>

#include "tegata/base/error.h"

namespace tegata::bench {
namespace {

constexpr int kRounds = 15;
constexpr int kRoundsOfSlowOnes = 3;
constexpr double kSlow = 0.5;           // [s]
constexpr double kSecondsATurn = 0.03;  // that a contestant is called for, or once
constexpr int kMostCallsATurn = 50;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::size_t call(const Contestant& contestant, std::size_t expected, bool has_expected) {
  const std::size_t result = contestant.run();
  if (has_expected && result != expected) {
    throw Error("bench: '", contestant.name, "' returned ", result, ", expected ", expected,
                " as the time before");
  }
  return result;
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::vector<Timing> run_rounds(const std::vector<Contestant>& contestants) {
  const std::size_t count = contestants.size();
  std::vector<Timing> timings(count);
  std::vector<int> calls(count), rounds(count, kRounds);
  for (std::size_t i = 0; i < count; ++i) {
    double start = cpu_seconds();
    timings[i].result = call(contestants[i], 0, false);
    if (cpu_seconds() - start > kSlow) {
      rounds[i] = kRoundsOfSlowOnes;
      calls[i] = 1;
      continue;
    }
    start = cpu_seconds();
    call(contestants[i], timings[i].result, true);
    calls[i] =
        std::clamp(static_cast<int>(kSecondsATurn / (cpu_seconds() - start)), 1, kMostCallsATurn);
  }

  std::vector<std::vector<double>> seconds(count);  // by contestant and round
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t turn = 0; turn < count; ++turn) {
      const std::size_t i = (turn + static_cast<std::size_t>(round)) % count;
      if (round >= rounds[i]) continue;
      const double start = cpu_seconds();
      for (int n = 0; n < calls[i]; ++n) call(contestants[i], timings[i].result, true);
      seconds[i].push_back((cpu_seconds() - start) / calls[i]);
    }
  }

  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> ratios;
    for (std::size_t r = 0; r < std::min(seconds[i].size(), seconds[0].size()); ++r) {
      ratios.push_back(seconds[i][r] / seconds[0][r]);
    }
    timings[i].milliseconds = 1e3 * median(seconds[i]);
    timings[i].ratio = median(ratios);
  }
  return timings;
}

}  // namespace tegata::bench
