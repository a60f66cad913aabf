// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "tegata/hull/octree.h"

namespace tegata {

/// One T for each point of the lattice that was ever asked for, kept in dense bricks of 4^3 points
/// that are found by hashing: neighbours lie together, and most look-ups stay in the last brick.
template <typename T>
class LatticeMap {
 public:
  /// `initial` is what a point has before anything is written to it.
  explicit LatticeMap(const T& initial) : initial_(initial), slots_(64, kNone) {}

  /// The value of a point; the reference stays valid.
  T& operator[](const LatticeIndex& index) {
    const LatticeIndex brick = {index[0] >> kBits, index[1] >> kBits, index[2] >> kBits};
    if (last_ == nullptr || !same(last_->position, brick)) last_ = &find(brick);
    constexpr std::int32_t kMask = (1 << kBits) - 1;
    return last_->values[static_cast<std::size_t>(
        (((index[2] & kMask) << kBits | (index[1] & kMask)) << kBits) | (index[0] & kMask))];
  }

 private:
  static constexpr int kBits = 2;
  static constexpr std::uint32_t kNone = ~0u;
  struct Brick {
    LatticeIndex position;
    std::array<T, std::size_t{1} << (3 * kBits)> values;
  };

  // What == of arrays does, without a call of memcmp.
  static bool same(const LatticeIndex& a, const LatticeIndex& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }

  // The slot that holds the brick, or the free one where it belongs.
  std::size_t slot_of(const LatticeIndex& position) const {
    std::uint64_t hash = 0;
    for (const std::int32_t coordinate : position) {
      hash = (hash ^ static_cast<std::uint32_t>(coordinate)) * 0x9E3779B97F4A7C15u;
    }
    std::size_t slot = static_cast<std::size_t>(hash >> 32) & (slots_.size() - 1);
    while (slots_[slot] != kNone && !same(bricks_[slots_[slot]].position, position)) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }

  Brick& find(const LatticeIndex& position) {
    std::size_t slot = slot_of(position);
    if (slots_[slot] != kNone) return bricks_[slots_[slot]];
    if (2 * (bricks_.size() + 1) > slots_.size()) {
      slots_.assign(2 * slots_.size(), kNone);
      for (std::uint32_t i = 0; i < bricks_.size(); ++i) slots_[slot_of(bricks_[i].position)] = i;
      slot = slot_of(position);
    }
    slots_[slot] = static_cast<std::uint32_t>(bricks_.size());
    Brick& brick = bricks_.emplace_back();
    brick.position = position;
    brick.values.fill(initial_);
    return brick;
  }

  T initial_;
  std::vector<std::uint32_t> slots_;
  std::deque<Brick> bricks_;
  Brick* last_ = nullptr;
};

}  // namespace tegata
