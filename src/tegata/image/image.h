// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tegata {

/// A picture of `channels` values a pixel, row by row from the top left, channels interleaved.
template <typename T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, T value = T{}, int channels = 1)
      : width_(width),
        height_(height),
        channels_(channels),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                    static_cast<std::size_t>(channels),
                value) {}

  int width() const { return width_; }
  int height() const { return height_; }
  int channels() const { return channels_; }
  bool empty() const { return values_.empty(); }
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  T& operator()(int x, int y, int channel = 0) { return values_[offset(x, y, channel)]; }
  const T& operator()(int x, int y, int channel = 0) const {
    return values_[offset(x, y, channel)];
  }
  std::vector<T>& values() { return values_; }
  const std::vector<T>& values() const { return values_; }

  bool operator==(const Image&) const = default;

 private:
  std::size_t offset(int x, int y, int channel) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels_) +
           static_cast<std::size_t>(channel);
  }

  int width_ = 0;
  int height_ = 0;
  int channels_ = 1;
  std::vector<T> values_;
};

/// A picture as a camera or a file gives it: 1 channel, or 3 in the order red, green, blue. Values
/// run from 0 to 2^bits - 1, where bits is 8 or 16.
struct CameraImage {
  Image<std::uint16_t> values;
  int bits = 8;
};

}  // namespace tegata
