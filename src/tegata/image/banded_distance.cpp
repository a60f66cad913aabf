// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Distances along the columns by two sweeps, then in each row the least of (x - q)^2 + height^2
// over the few q of the band: loops without branches over 16-bit numbers.
#include "tegata/image/banded_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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

// Columns are taken so many at a time.
constexpr std::size_t kChunk = 64;

// One row: what each pixel looks for has these squared steps along the columns. Both begin `band`
// entries before the first pixel and go on as far, and a chunk, behind the last.
struct RowHeights {
  std::vector<std::int16_t> to_outside, to_inside;
};

// For each x of a chunk the least of heights[x + q] + q^2 over 0 <= q <= 2 band, less the band.
TEGATA_KERNEL void least_of_parabolas(const std::int16_t* heights, int band, std::int16_t* least) {
  std::array<std::int16_t, kChunk> lowest;
  lowest.fill(std::numeric_limits<std::int16_t>::max());
  for (int q = -band; q <= band; ++q) {
    const std::int16_t* shifted = heights + (band + q);
    const auto square = static_cast<std::int16_t>(q * q);
    for (std::size_t x = 0; x < kChunk; ++x) {
      const auto height = static_cast<std::int16_t>(shifted[x] + square);
      lowest[x] = height < lowest[x] ? height : lowest[x];
    }
  }
  for (std::size_t x = 0; x < kChunk; ++x) least[x] = lowest[x];
}

// The distances of a row of `columns` pixels.
TEGATA_KERNEL void measure_row(const RowHeights& heights, int band, const std::uint8_t* kind,
                               std::size_t columns, float* distance) {
  const float limit = static_cast<float>(band);
  for (std::size_t first = 0; first < columns; first += kChunk) {
    std::array<std::int16_t, kChunk> outside, inside;
    least_of_parabolas(heights.to_outside.data() + first, band, outside.data());
    least_of_parabolas(heights.to_inside.data() + first, band, inside.data());
    const std::size_t count = std::min(kChunk, columns - first);
    for (std::size_t x = 0; x < count; ++x) {
      const bool is_inside = kind[first + x] != 0;
      const float squared = static_cast<float>(is_inside ? outside[x] : inside[x]);
      const float length = std::min(std::sqrt(squared) - 0.5f, limit);
      distance[first + x] = is_inside ? length : -length;
    }
  }
}

using MeasureRow = void(const RowHeights&, int, const std::uint8_t*, std::size_t, float*);

void measure_row_baseline(const RowHeights& heights, int band, const std::uint8_t* kind,
                          std::size_t columns, float* distance) {
  measure_row(heights, band, kind, columns, distance);
}
TEGATA_AVX2 void measure_row_avx2(const RowHeights& heights, int band, const std::uint8_t* kind,
                                  std::size_t columns, float* distance) {
  measure_row(heights, band, kind, columns, distance);
}
TEGATA_AVX512 void measure_row_avx512(const RowHeights& heights, int band, const std::uint8_t* kind,
                                      std::size_t columns, float* distance) {
  measure_row(heights, band, kind, columns, distance);
}

}  // namespace

Image<float> banded_distance(const Image<std::uint8_t>& mask, int band, InstructionSet set) {
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
  constexpr std::array<MeasureRow*, 3> kMeasureRow = {measure_row_baseline, measure_row_avx2,
                                                      measure_row_avx512};
  const auto columns = static_cast<std::size_t>(width), margin = static_cast<std::size_t>(band);
  RowHeights heights;
  heights.to_outside.assign(columns + 2 * margin + kChunk, static_cast<std::int16_t>(far * far));
  heights.to_inside = heights.to_outside;
  Image<float> distance(width, height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* kind = &inside(0, y);
    const std::int16_t* step = &steps(0, y);
    std::int16_t* to_outside = heights.to_outside.data() + margin;
    std::int16_t* to_inside = heights.to_inside.data() + margin;
    for (std::size_t x = 0; x < columns; ++x) {
      const auto squared = static_cast<std::int16_t>(step[x] * step[x]);
      to_outside[x] = static_cast<std::int16_t>(squared * kind[x]);
      to_inside[x] = static_cast<std::int16_t>(squared * (1 - kind[x]));
    }
    kMeasureRow[static_cast<std::size_t>(set)](heights, band, kind, columns, &distance(0, y));
  }
  return distance;
}

}  // namespace tegata
