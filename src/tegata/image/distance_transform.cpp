// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// P. F. Felzenszwalb, D. P. Huttenlocher: Distance Transforms of Sampled Functions. Theory of
// Computing 8, 2012: along the columns by two sweeps, along the rows by the lower envelope of
// parabolas.
#include "tegata/image/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tegata/image/pixel_box.h"

namespace tegata {
namespace {

using Mask = Image<std::uint8_t>;

constexpr PixelLabel kLabels[] = {PixelLabel::background, PixelLabel::unknown, PixelLabel::hand};

PixelBox box_of(const Mask& mask) { return {0, 0, mask.width() - 1, mask.height() - 1}; }

PixelBox one_wider(const PixelBox& window, const PixelBox& limit) {
  return {std::max(window.left - 1, limit.left), std::max(window.top - 1, limit.top),
          std::min(window.right + 1, limit.right), std::min(window.bottom + 1, limit.bottom)};
}

// Steps along the columns of a window to the nearest pixel that carries `value`; `far`, which is
// farther than anything in the picture, where the column has none.
Image<int> column_distances(const Mask& mask, const PixelBox& window, std::uint8_t value, int far) {
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
  // `at` is 0 to width - 1.
  explicit LowerEnvelope(int width)
      : parabolas_(static_cast<std::size_t>(width)),
        ends_(static_cast<std::size_t>(width)),
        half_of_(static_cast<std::size_t>(width)) {
    for (std::size_t i = 1; i < half_of_.size(); ++i) half_of_[i] = 0.5 / static_cast<double>(i);
  }

  void clear() { count_ = 0; }
  // From left to right.
  void add(int at, int height) {
    const Parabola added{at, height, height + at * at};
    std::size_t count = count_;
    while (count > 0) {
      const double crossing = intersection(parabolas_[count - 1], added);
      if (count == 1 || crossing > ends_[count - 2]) {
        ends_[count - 1] = crossing;
        break;
      }
      --count;
    }
    parabolas_[count] = added;
    count_ = count + 1;
  }
  // The squares at 0 .. width - 1.
  void sample(int width, float* squares) const {
    int x = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const auto at = static_cast<float>(parabolas_[i].at);
      const auto height = static_cast<float>(parabolas_[i].height);
      const int end =
          i + 1 < count_ && ends_[i] < width ? std::max(x, rounded_up(ends_[i])) : width;
      for (; x < end; ++x) {
        const float step = static_cast<float>(x) - at;
        squares[x] = step * step + height;
      }
    }
  }

 private:
  struct Parabola {
    int at, height, at_zero;  // at_zero: its value at x = 0
  };
  // Where the right one of the two comes below the left one. Where that is at a pixel's centre both
  // have the same value there, so that the product's rounding does not show.
  double intersection(const Parabola& left, const Parabola& right) const {
    return (right.at_zero - left.at_zero) * half_of_[static_cast<std::size_t>(right.at - left.at)];
  }
  // Of what is below 0, 0.
  static int rounded_up(double value) {
    if (!(value > 0.0)) return 0;
    const int whole = static_cast<int>(value);
    return whole < value ? whole + 1 : whole;
  }

  std::vector<Parabola> parabolas_;
  std::vector<double> ends_;     // of each parabola's stretch but the last one's
  std::vector<double> half_of_;  // half of the reciprocals
  std::size_t count_ = 0;
};

// Adds sign * (distance to the nearest pixel with `value` - 0.5) to the pixels of a window without
// it. Only the columns from `left` to `right` have such pixels that are the nearest to any.
void add_distances(const Mask& mask, const PixelBox& window, int left, int right,
                   std::uint8_t value, float sign, Image<float>& sum) {
  const int far = mask.width() + mask.height();
  const PixelBox looked_for{left, window.top, right, window.bottom};
  const Image<int> along_columns = column_distances(mask, looked_for, value, far);
  LowerEnvelope envelope(window.width());
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
  Mask mask(silhouette.width(), silhouette.height());
  std::uint8_t kinds[3];
  for (std::size_t i = 0; i < 3; ++i) kinds[i] = inside(kLabels[i]) ? 1 : 0;
  std::transform(silhouette.values().begin(), silhouette.values().end(), mask.values().begin(),
                 [&](PixelLabel label) {
                   return static_cast<std::uint8_t>((label == kLabels[0] ? kinds[0] : 0) |
                                                    (label == kLabels[1] ? kinds[1] : 0) |
                                                    (label == kLabels[2] ? kinds[2] : 0));
                 });

  const PixelBox inside_bounds = bounds_of(mask, std::uint8_t{1});
  const float far = static_cast<float>(mask.width() + mask.height());
  if (inside_bounds.empty()) return Image<float>(mask.width(), mask.height(), -far);
  if (std::memchr(mask.values().data(), 0, mask.pixel_count()) == nullptr) {
    return Image<float>(mask.width(), mask.height(), far);
  }
  Image<float> distance(mask.width(), mask.height(), 0.0F);
  // The nearest pixel outside is not farther than the frame about all that is inside.
  const PixelBox frame = one_wider(inside_bounds, box_of(mask));
  add_distances(mask, frame, frame.left, frame.right, 0, 1.0F, distance);
  add_distances(mask, box_of(mask), inside_bounds.left, inside_bounds.right, 1, -1.0F, distance);
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
