// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tegata::bench {

/// One way to do a benchmark's work.
struct Contestant {
  std::string name;
  /// Does all of the work and returns a number that it depends on, the same every time.
  std::function<std::size_t()> run;
  double bar = 0.0;  ///< what its time over ours is to reach; 0: no bar
};

struct Timing {
  double milliseconds = 0.0;  ///< median over the rounds
  double ratio = 0.0;         ///< to the first contestant: median of the rounds' ratios
  std::size_t result = 0;     ///< what run() returned
};

enum class Clock { processor, wall };

/// Runs the contestants in turn, round after round, so that a busy machine slows all of them. In a
/// round each is called until it has taken a few milliseconds, and its mean time counts; each round
/// starts with another one. Processor time is the process's on any core: waiting for other
/// processes does not count, further threads that a library starts in spite of all do; what several
/// threads gain is seen by the clock alone. Calls before the first round are not counted.
/// Contestants of more than half a second take part in the first few rounds only. Throws Error
/// where run() returns something else than the time before.
std::vector<Timing> run_rounds(const std::vector<Contestant>& contestants,
                               Clock clock = Clock::processor, int rounds_of_slow_ones = 3);

double median(std::vector<double> values);

}  // namespace tegata::bench
