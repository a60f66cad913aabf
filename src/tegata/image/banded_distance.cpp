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

// From a row whose steps along the columns to the nearest pixel of the other kind are known to the
// next: the least of what is there and of one step more, or one step where the kinds differ. Kinds
// are 0 or 1.
TEGATA_KERNEL void sweep_row(const std::int16_t* kind_before, const std::int16_t* before,
                             const std::int16_t* kind, std::int16_t* steps, std::size_t columns) {
  for (std::size_t x = 0; x < columns; ++x) {
    const auto same = static_cast<std::int16_t>(kind[x] == kind_before[x] ? -1 : 0);
    const auto onwards = static_cast<std::int16_t>((before[x] & same) + 1);
    steps[x] = onwards < steps[x] ? onwards : steps[x];
  }
}

// Columns are taken so many at a time.
constexpr std::size_t kChunk = 32;

// One row: what each pixel looks for has these squared steps along the columns. Both begin `band`
// entries before the first pixel and go on as far, and a chunk, behind the last.
struct RowHeights {
  std::vector<std::int16_t> to_outside, to_inside;
};

// For each x of a chunk the least of heights[x + q] + q^2 over 0 <= q <= 2 band, less the band.
TEGATA_KERNEL void least_of_parabolas(const std::int16_t* heights, int band, std::int16_t* least) {
  std::array<std::int16_t, kChunk> lowest;
  const auto far = static_cast<std::int16_t>((band + 1) * (band + 1));
  std::int16_t nearest = far;
  for (std::size_t x = 0; x < kChunk + 2 * static_cast<std::size_t>(band); ++x) {
    nearest = heights[x] < nearest ? heights[x] : nearest;
  }
  if (nearest == far) {  // nothing in reach
    for (std::size_t x = 0; x < kChunk; ++x) least[x] = far;
    return;
  }
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
TEGATA_KERNEL void measure_row(const RowHeights& heights, int band, const std::int16_t* kind,
                               std::size_t columns, float* distance) {
  const float limit = static_cast<float>(band);
  for (std::size_t first = 0; first < columns; first += kChunk) {
    const std::size_t count = std::min(kChunk, columns - first);
    std::array<std::int16_t, kChunk> outside{}, inside{};
    int inside_count = 0;
    for (std::size_t x = 0; x < count; ++x) inside_count += kind[first + x];
    // Most chunks are of one kind, of which only one other is looked for.
    if (inside_count > 0) {
      least_of_parabolas(heights.to_outside.data() + first, band, outside.data());
    }
    if (inside_count < static_cast<int>(count)) {
      least_of_parabolas(heights.to_inside.data() + first, band, inside.data());
    }
    for (std::size_t x = 0; x < count; ++x) {
      const bool is_inside = kind[first + x] != 0;
      const float squared = static_cast<float>(is_inside ? outside[x] : inside[x]);
      const float length = std::min(std::sqrt(squared) - 0.5f, limit);
      distance[first + x] = is_inside ? length : -length;
    }
  }
}

TEGATA_KERNEL void measure(const Image<std::int16_t>& kinds, int band, Image<float>& distance) {
  const int height = kinds.height();
  const auto columns = static_cast<std::size_t>(kinds.width());
  const auto margin = static_cast<std::size_t>(band);
  const auto far = static_cast<std::int16_t>(band + 1);
  Image<std::int16_t> steps(kinds.width(), height, far);
  for (int y = 1; y < height; ++y) {
    sweep_row(&kinds(0, y - 1), &steps(0, y - 1), &kinds(0, y), &steps(0, y), columns);
  }
  for (int y = height - 2; y >= 0; --y) {
    sweep_row(&kinds(0, y + 1), &steps(0, y + 1), &kinds(0, y), &steps(0, y), columns);
  }
  // A pixel looks for the other kind: which has height 0, or the steps to it along the column.
  RowHeights heights;
  heights.to_outside.assign(columns + 2 * margin + kChunk, static_cast<std::int16_t>(far * far));
  heights.to_inside = heights.to_outside;
  for (int y = 0; y < height; ++y) {
    const std::int16_t *kind = &kinds(0, y), *step = &steps(0, y);
    std::int16_t* to_outside = heights.to_outside.data() + margin;
    std::int16_t* to_inside = heights.to_inside.data() + margin;
    for (std::size_t x = 0; x < columns; ++x) {
      const auto squared = static_cast<std::int16_t>(step[x] * step[x]);
      to_outside[x] = static_cast<std::int16_t>(squared & -kind[x]);
      to_inside[x] = static_cast<std::int16_t>(squared & (kind[x] - 1));
    }
    measure_row(heights, band, kind, columns, &distance(0, y));
  }
}

using Measure = void(const Image<std::int16_t>&, int, Image<float>&);

void measure_baseline(const Image<std::int16_t>& kinds, int band, Image<float>& distance) {
  measure(kinds, band, distance);
}
TEGATA_AVX2 void measure_avx2(const Image<std::int16_t>& kinds, int band, Image<float>& distance) {
  measure(kinds, band, distance);
}
TEGATA_AVX512 void measure_avx512(const Image<std::int16_t>& kinds, int band,
                                  Image<float>& distance) {
  measure(kinds, band, distance);
}

}  // namespace

Image<float> banded_distance(const Image<std::uint8_t>& mask, int band, InstructionSet set) {
  if (band < 1 || band > kMostBand) {
    throw Error("distance: got a band of ", band, " pixels, expected 1 to ", kMostBand);
  }
  Image<std::int16_t> kinds(mask.width(), mask.height());
  const std::uint8_t* values = mask.values().data();
  std::int16_t* kind = kinds.values().data();
  for (std::size_t i = 0; i < mask.pixel_count(); ++i) kind[i] = values[i] != 0 ? 1 : 0;

  constexpr std::array<Measure*, 3> kMeasure = {measure_baseline, measure_avx2, measure_avx512};
  Image<float> distance(mask.width(), mask.height());
  kMeasure[static_cast<std::size_t>(set)](kinds, band, distance);
  return distance;
}

}  // namespace tegata
