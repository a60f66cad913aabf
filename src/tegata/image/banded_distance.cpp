// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Distances along the columns by two sweeps, then in each row the least of (x - q)^2 + height^2
// over the few q of the band: loops without branches over 16-bit numbers.
#include "tegata/image/banded_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tegata/base/error.h"

namespace tegata {
namespace {

// Steps along the column to the nearest pixel of the other kind, at most `far`.
Image<std::int16_t> column_distances(const Image<std::uint8_t>& inside, std::int16_t far) {
  const int width = inside.width(), height = inside.height();
  Image<std::int16_t> steps(width, height, far);
  // From the row before, whose steps are known, to the next.
  const auto sweep = [&](int from, int to) {
    const std::uint8_t *kind_before = &inside(0, from), *kind = &inside(0, to);
    const std::int16_t* before = &steps(0, from);
    std::int16_t* here = &steps(0, to);
    for (int x = 0; x < width; ++x) {
      const int onwards = kind[x] != kind_before[x] ? 1 : before[x] + 1;
      here[x] = static_cast<std::int16_t>(std::min<int>(here[x], onwards));
    }
  };
  for (int y = 1; y < height; ++y) sweep(y - 1, y);
  for (int y = height - 2; y >= 0; --y) sweep(y + 1, y);
  return steps;
}

// For each x the least of heights[x + q] + q^2 over -band <= q <= band. `heights` begins `band`
// entries before x = 0 and goes on as far behind the last.
void sample_envelope(const std::vector<std::int16_t>& heights, int band,
                     std::vector<std::int16_t>& least) {
  const std::size_t width = least.size();
  std::fill(least.begin(), least.end(), heights.front());
  for (int q = -band; q <= band; ++q) {
    const std::int16_t* shifted = heights.data() + (band + q);
    const auto square = static_cast<std::int16_t>(q * q);
    for (std::size_t x = 0; x < width; ++x) {
      const auto height = static_cast<std::int16_t>(shifted[x] + square);
      least[x] = height < least[x] ? height : least[x];
    }
  }
}

}  // namespace

Image<float> banded_distance(const Image<std::uint8_t>& mask, int band) {
  if (band < 1 || band > kMostBand) {
    throw Error("distance: got a band of ", band, " pixels, expected 1 to ", kMostBand);
  }
  const int width = mask.width(), height = mask.height();
  Image<std::uint8_t> inside(width, height);
  std::transform(mask.values().begin(), mask.values().end(), inside.values().begin(),
                 [](std::uint8_t value) { return value != 0 ? std::uint8_t{1} : std::uint8_t{0}; });
  const auto far = static_cast<std::int16_t>(band + 1);
  const Image<std::int16_t> steps = column_distances(inside, far);

  // A pixel looks for the other kind: which has height 0, or the steps to it along the column.
  const auto columns = static_cast<std::size_t>(width);
  const auto margin = static_cast<std::size_t>(band);
  const auto far_squared = static_cast<std::int16_t>(far * far);
  std::vector<std::int16_t> to_outside(columns + 2 * margin, far_squared), to_inside = to_outside;
  std::vector<std::int16_t> outside_least(columns), inside_least(columns);
  Image<float> distance(width, height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* kind = &inside(0, y);
    const std::int16_t* step = &steps(0, y);
    for (std::size_t x = 0; x < columns; ++x) {
      const auto squared = static_cast<std::int16_t>(step[x] * step[x]);
      to_outside[margin + x] = static_cast<std::int16_t>(squared * kind[x]);
      to_inside[margin + x] = static_cast<std::int16_t>(squared * (1 - kind[x]));
    }
    sample_envelope(to_outside, band, outside_least);
    sample_envelope(to_inside, band, inside_least);
    float* result = &distance(0, y);
    for (std::size_t x = 0; x < columns; ++x) {
      const auto squared = static_cast<float>(kind[x] != 0 ? outside_least[x] : inside_least[x]);
      const float length = std::min(std::sqrt(squared) - 0.5f, static_cast<float>(band));
      result[x] = kind[x] != 0 ? length : -length;
    }
  }
  return distance;
}

}  // namespace tegata
