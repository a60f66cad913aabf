// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace tegata {

/// Seeded random numbers that are the same on every platform: the standard fixes the engine's
/// output but not that of its distributions, so these are written out.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double uniform(double low = 0.0, double high = 1.0);
  /// Normal with the given mean and standard deviation (Box and Muller 1958).
  double normal(double mean = 0.0, double standard_deviation = 1.0);
  /// Uniform in 0 .. count - 1; count must be positive.
  std::uint64_t index(std::uint64_t count);

 private:
  std::mt19937_64 engine_;
};

}  // namespace tegata
