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

// Steps along the column to the nearest pixel that carries `value`; width + height, which is
// farther than anything in the picture, where the column has none.
Image<int> column_distances(const Mask& mask, std::uint8_t value) {
  const int width = mask.width(), height = mask.height(), far = width + height;
  Image<int> distance(width, height);
  for (int x = 0; x < width; ++x) distance(x, 0) = mask(x, 0) == value ? 0 : far;
  for (int y = 1; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      distance(x, y) = mask(x, y) == value ? 0 : std::min(far, distance(x, y - 1) + 1);
    }
  }
  for (int y = height - 2; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      distance(x, y) = std::min(distance(x, y), distance(x, y + 1) + 1);
    }
  }
  return distance;
}

// The lower envelope of the parabolas (x - q)^2 + heights[q], sampled at every x.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(int width)
      : heights_(static_cast<std::size_t>(width)),
        vertex_(static_cast<std::size_t>(width)),
        start_(static_cast<std::size_t>(width)) {}

  std::vector<double>& heights() { return heights_; }

  template <typename Visit>
  void sample(const Visit& visit) {
    std::size_t last = 0;
    vertex_[0] = 0;
    for (std::size_t q = 1; q < heights_.size(); ++q) {
      double crossing = intersection(vertex_[last], q);
      while (last > 0 && crossing <= start_[last]) crossing = intersection(vertex_[--last], q);
      vertex_[++last] = q;
      start_[last] = crossing;
    }
    std::size_t current = 0;
    for (std::size_t x = 0; x < heights_.size(); ++x) {
      while (current < last && start_[current + 1] <= static_cast<double>(x)) ++current;
      const double step = static_cast<double>(x) - static_cast<double>(vertex_[current]);
      visit(static_cast<int>(x), step * step + heights_[vertex_[current]]);
    }
  }

 private:
  // Where parabola q, the right one of the two, comes below parabola p.
  double intersection(std::size_t p, std::size_t q) const {
    const double a = static_cast<double>(p), b = static_cast<double>(q);
    return ((heights_[q] + b * b) - (heights_[p] + a * a)) / (2.0 * (b - a));
  }

  std::vector<double> heights_;
  std::vector<std::size_t> vertex_;
  std::vector<double> start_;  // of each parabola's stretch; the first one's is never read
};

// Adds sign * (distance to the nearest pixel with `value` - 0.5) to the pixels without it.
void add_distances(const Mask& mask, std::uint8_t value, float sign, Image<float>& sum) {
  const Image<int> along_columns = column_distances(mask, value);
  LowerEnvelope envelope(mask.width());
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      const double distance = along_columns(x, y);
      envelope.heights()[static_cast<std::size_t>(x)] = distance * distance;
    }
    envelope.sample([&](int x, double squared) {
      if (squared > 0.0) sum(x, y) += sign * static_cast<float>(std::sqrt(squared) - 0.5);
    });
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
  add_distances(mask, 0, 1.0F, distance);
  add_distances(mask, 1, -1.0F, distance);
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
