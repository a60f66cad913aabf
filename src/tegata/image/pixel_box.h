// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "tegata/image/image.h"

namespace tegata {

/// A part of a picture, its last column and row included.
struct PixelBox {
  int left = 0, top = 0, right = -1, bottom = -1;

  bool empty() const { return right < left || bottom < top; }
  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
};

/// The least box that has all pixels of a value; empty where there are none.
template <typename Byte>
PixelBox bounds_of(const Image<Byte>& image, Byte value) {
  static_assert(sizeof(Byte) == 1);
  const auto width = static_cast<std::size_t>(image.width());
  PixelBox box{image.width(), image.height(), -1, -1};
  for (int y = 0; y < image.height() && width > 0; ++y) {
    const Byte* const row = &image(0, y);
    const void* const first = std::memchr(row, static_cast<int>(value), width);
    if (first == nullptr) continue;
    int last = image.width() - 1;
    while (row[last] != value) --last;
    box = {std::min(box.left, static_cast<int>(static_cast<const Byte*>(first) - row)),
           std::min(box.top, y), std::max(box.right, last), y};
  }
  return box;
}

}  // namespace tegata
