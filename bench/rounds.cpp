// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "rounds.h"

#include <algorithm>
#include <ctime>

#include "tegata/base/error.h"

namespace tegata::bench {
namespace {

constexpr int kRounds = 15;
constexpr double kSlow = 0.5;           // [s]
constexpr double kSecondsATurn = 0.03;  // that a contestant is called for, or once
constexpr int kMostCallsATurn = 50;

double seconds_by(Clock clock) {
  timespec now{};
  clock_gettime(clock == Clock::processor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
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

std::vector<Timing> run_rounds(const std::vector<Contestant>& contestants, Clock clock,
                               int rounds_of_slow_ones) {
  const std::size_t count = contestants.size();
  std::vector<Timing> timings(count);
  std::vector<int> calls(count), rounds(count, kRounds);
  for (std::size_t i = 0; i < count; ++i) {
    double start = seconds_by(clock);
    timings[i].result = call(contestants[i], 0, false);
    if (seconds_by(clock) - start > kSlow) {
      rounds[i] = rounds_of_slow_ones;
      calls[i] = 1;
      continue;
    }
    start = seconds_by(clock);
    call(contestants[i], timings[i].result, true);
    calls[i] = std::clamp(static_cast<int>(kSecondsATurn / (seconds_by(clock) - start)), 1,
                          kMostCallsATurn);
  }

  std::vector<std::vector<double>> seconds(count);  // by contestant and round
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t turn = 0; turn < count; ++turn) {
      const std::size_t i = (turn + static_cast<std::size_t>(round)) % count;
      if (round >= rounds[i]) continue;
      const double start = seconds_by(clock);
      for (int n = 0; n < calls[i]; ++n) call(contestants[i], timings[i].result, true);
      seconds[i].push_back((seconds_by(clock) - start) / calls[i]);
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
