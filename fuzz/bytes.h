// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>

namespace tegata {

/// What a fuzzer gives, drawn value by value; zeros where nothing is left.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  std::uint8_t byte() { return draw<std::uint8_t>(); }
  /// 0 .. count - 1.
  int index(int count) { return byte() % count; }
  /// -1 .. 1.
  double fraction() { return draw<std::int16_t>() / 32768.0; }
  /// Any number, also one that is not finite.
  double any_number() { return draw<double>(); }

 private:
  template <typename T>
  T draw() {
    T value{};
    const std::size_t count = std::min(sizeof value, left_.size());
    if (count > 0) std::memcpy(&value, left_.data(), count);
    left_ = left_.subspan(count);
    return value;
  }

  std::span<const std::uint8_t> left_;
};

/// Ends the program, which makes the input a finding.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "finding: %s\n", what);
  std::abort();
}

}  // namespace tegata
