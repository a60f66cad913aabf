// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// P. F. Felzenszwalb, D. P. Huttenlocher: Distance Transforms of Sampled Functions. Theory of
// Computing 8, 2012: along the columns by two sweeps, along the rows by the lower envelope of
// parabolas.
#include "tegata/image/distance_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tegata {
namespace {

using Mask = Image<std::uint8_t>;

// A part of a picture, its last column and row included.
struct Window {
  int left = 0, top = 0, right = -1, bottom = -1;

  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
};

Window window_of(const Mask& mask) { return {0, 0, mask.width() - 1, mask.height() - 1}; }

// Where the pixels that are not 0 are.
Window bounds(const Mask& mask) {
  Window found{mask.width(), mask.height(), -1, -1};
  for (int y = 0; y < mask.height(); ++y) {
    const std::uint8_t* row = &mask(0, y);
    for (int x = 0; x < mask.width(); ++x) {
      if (row[x] == 0) continue;
      found = {std::min(found.left, x), std::min(found.top, y), std::max(found.right, x), y};
    }
  }
  return found;
}

Window one_wider(const Window& window, const Window& limit) {
  return {std::max(window.left - 1, limit.left), std::max(window.top - 1, limit.top),
          std::min(window.right + 1, limit.right), std::min(window.bottom + 1, limit.bottom)};
}

// Steps along the columns of a window to the nearest pixel that carries `value`; `far`, which is
// farther than anything in the picture, where the column has none.
Image<int> column_distances(const Mask& mask, const Window& window, std::uint8_t value, int far) {
  Image<int> distance(window.width(), window.height(), far);
  const auto sweep = [&](int y, int before) {
    const std::uint8_t* pixels = &mask(window.left, window.top + y);
    const int* onwards = &distance(0, before);
    int* steps = &distance(0, y);
    for (int x = 0; x < window.width(); ++x) {
      const int least = std::min(steps[x], onwards[x] + 1);
      steps[x] = pixels[x] == value ? 0 : least;
    }
  };
  sweep(0, 0);
  for (int y = 1; y < window.height(); ++y) sweep(y, y - 1);
  for (int y = window.height() - 2; y >= 0; --y) sweep(y, y + 1);
  return distance;
}

// The lower envelope of the parabolas (x - at)^2 + height, sampled at every x of a row. Columns
// without a pixel that is looked for have none.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(int width) {
    parabolas_.reserve(static_cast<std::size_t>(width));
    ends_.reserve(static_cast<std::size_t>(width));
  }

  void clear() {
    parabolas_.clear();
    ends_.clear();
  }
  // From left to right.
  void add(int at, int height) {
    const Parabola added{static_cast<double>(at), static_cast<double>(height)};
    while (!parabolas_.empty()) {
      const double crossing = intersection(parabolas_.back(), added);
      if (ends_.empty() || crossing > ends_.back()) {
        ends_.push_back(crossing);
        break;
      }
      parabolas_.pop_back();
      ends_.pop_back();
    }
    parabolas_.push_back(added);
  }
  // The squares at 0 .. width - 1.
  void sample(int width, float* squares) const {
    int x = 0;
    for (std::size_t i = 0; i < parabolas_.size(); ++i) {
      const auto at = static_cast<float>(parabolas_[i].at);
      const auto height = static_cast<float>(parabolas_[i].height);
      // The first x at which the next one is not higher.
      const int end = i < ends_.size() && ends_[i] < width
                          ? std::max(x, static_cast<int>(std::ceil(ends_[i])))
                          : width;
      for (; x < end; ++x) {
        const float step = static_cast<float>(x) - at;
        squares[x] = step * step + height;
      }
    }
  }

 private:
  struct Parabola {
    double at, height;
  };
  // Where the right one of the two comes below the left one.
  static double intersection(const Parabola& left, const Parabola& right) {
    return ((right.height + right.at * right.at) - (left.height + left.at * left.at)) /
           (2.0 * (right.at - left.at));
  }

  std::vector<Parabola> parabolas_;
  std::vector<double> ends_;  // of each parabola's stretch but the last one's
};

// Adds sign * (distance to the nearest pixel with `value` - 0.5) to the pixels of a window without
// it. Only the columns from `left` to `right` have such pixels that are the nearest to any.
void add_distances(const Mask& mask, const Window& window, int left, int right, std::uint8_t value,
                   float sign, Image<float>& sum) {
  const int far = mask.width() + mask.height();
  const Window looked_for{left, window.top, right, window.bottom};
  const Image<int> along_columns = column_distances(mask, looked_for, value, far);
  LowerEnvelope envelope(looked_for.width());
  std::vector<float> squares(static_cast<std::size_t>(window.width()));
  for (int y = window.top; y <= window.bottom; ++y) {
    const int* steps = &along_columns(0, y - window.top);
    envelope.clear();
    for (int x = 0; x < looked_for.width(); ++x) {
      if (steps[x] < far) envelope.add(left - window.left + x, steps[x] * steps[x]);
    }
    envelope.sample(window.width(), squares.data());
    const std::uint8_t* pixels = &mask(window.left, y);
    float* row = &sum(window.left, y);
    for (int x = 0; x < window.width(); ++x) {
      const float length = sign * (std::sqrt(squares[static_cast<std::size_t>(x)]) - 0.5F);
      row[x] += pixels[x] == value ? 0.0F : length;
    }
  }
}

}  // namespace

Image<float> signed_distance(const Silhouette& silhouette,
                             const std::function<bool(PixelLabel)>& inside) {
  std::array<std::uint8_t, 256> is_inside = {};
  for (const PixelLabel label : {PixelLabel::background, PixelLabel::unknown, PixelLabel::hand}) {
    is_inside[static_cast<std::size_t>(label)] = inside(label) ? 1 : 0;
  }
  Mask mask(silhouette.width(), silhouette.height());
  std::transform(silhouette.values().begin(), silhouette.values().end(), mask.values().begin(),
                 [&](PixelLabel label) { return is_inside[static_cast<std::size_t>(label)]; });

  const auto first = mask.values().begin();
  const auto inside_count = std::count(first, mask.values().end(), std::uint8_t{1});
  const float far = static_cast<float>(mask.width() + mask.height());
  if (inside_count == 0) return Image<float>(mask.width(), mask.height(), -far);
  if (static_cast<std::size_t>(inside_count) == mask.pixel_count()) {
    return Image<float>(mask.width(), mask.height(), far);
  }
  Image<float> distance(mask.width(), mask.height(), 0.0F);
  // The nearest pixel outside is not farther than the frame about all that is inside.
  const Window inside_bounds = bounds(mask);
  const Window frame = one_wider(inside_bounds, window_of(mask));
  add_distances(mask, frame, frame.left, frame.right, 0, 1.0F, distance);
  add_distances(mask, window_of(mask), inside_bounds.left, inside_bounds.right, 1, -1.0F, distance);
  return distance;
}

float sample_bilinear(const Image<float>& image, double x, double y) {
  const double clamped_x = std::clamp(x, 0.0, static_cast<double>(image.width() - 1));
  const double clamped_y = std::clamp(y, 0.0, static_cast<double>(image.height() - 1));
  const int left = static_cast<int>(clamped_x), top = static_cast<int>(clamped_y);
  const int right = std::min(left + 1, image.width() - 1);
  const int bottom = std::min(top + 1, image.height() - 1);
  const float u = static_cast<float>(clamped_x - left), v = static_cast<float>(clamped_y - top);
  const float upper = image(left, top) + u * (image(right, top) - image(left, top));
  const float lower = image(left, bottom) + u * (image(right, bottom) - image(left, bottom));
  return upper + v * (lower - upper);
}

}  // namespace tegata
