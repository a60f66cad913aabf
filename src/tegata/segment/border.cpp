// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// R. A. Fisher: The Use of Multiple Measurements in Taxonomic Problems. Annals of Eugenics 7, 1936:
// the direction in which two classes with a common spread S and means a, b are told apart best is
// S^-1 (a - b).
// G. Borgefors: Distance Transformations in Digital Images. Computer Vision, Graphics, and Image
// Processing 34, 1986: the distances, in steps of 2 to a side and 3 over a corner.
#include "tegata/segment/border.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tegata/base/error.h"

namespace tegata {
namespace {

template <int N>
using Levels = Eigen::Matrix<double, N, 1>;

template <int N>
Levels<N> value_at(const float* pixel) {
  Levels<N> value;
  for (int c = 0; c < N; ++c) value[c] = static_cast<double>(pixel[c]);
  return value;
}

// A part of the picture, in whole pixels.
struct Part {
  int x = 0, y = 0, width = 0, height = 0;
};

// Grown by `margin` pixels on each side, but not over the edge of the picture.
Part grown(const Part& part, int margin, const Silhouette& silhouette) {
  const int left = std::max(0, part.x - margin), top = std::max(0, part.y - margin);
  return {left, top, std::min(silhouette.width(), part.x + part.width + margin) - left,
          std::min(silhouette.height(), part.y + part.height + margin) - top};
}

// The labels of a row, as the numbers that they are: loops over bytes become vectors.
const std::uint8_t* row_of(const Silhouette& silhouette, int y) {
  return reinterpret_cast<const std::uint8_t*>(silhouette.values().data()) +
         static_cast<std::ptrdiff_t>(y) * silhouette.width();
}
constexpr auto kHand = static_cast<std::uint8_t>(PixelLabel::hand);
constexpr auto kUnknown = static_cast<std::uint8_t>(PixelLabel::unknown);

// The box of all pixels with another label than their neighbour's on the right or below, and of
// these neighbours.
Part box_of_borders(const Silhouette& silhouette) {
  const int width = silhouette.width(), height = silhouette.height();
  std::vector<std::uint8_t> across(static_cast<std::size_t>(width), 0), down = across;
  int top = height, bottom = 0;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* const row = row_of(silhouette, y);
    const std::uint8_t* const below = row_of(silhouette, std::min(y + 1, height - 1));
    std::uint8_t differs_across = 0, differs_down = 0;
    for (int x = 0; x + 1 < width; ++x) {
      const auto differs = static_cast<std::uint8_t>(row[x] ^ row[x + 1]);
      across[static_cast<std::size_t>(x)] |= differs;
      differs_across |= differs;
    }
    for (int x = 0; x < width; ++x) {
      const auto differs = static_cast<std::uint8_t>(row[x] ^ below[x]);
      down[static_cast<std::size_t>(x)] |= differs;
      differs_down |= differs;
    }
    if (differs_across == 0 && differs_down == 0) continue;
    top = std::min(top, y);
    bottom = std::max(bottom, differs_down != 0 ? y + 2 : y + 1);
  }
  if (bottom == 0) return {};
  int left = width, right = 0;
  for (int x = 0; x < width; ++x) {
    const auto column = static_cast<std::size_t>(x);
    if (across[column] == 0 && down[column] == 0) continue;
    left = std::min(left, x);
    right = across[column] != 0 ? x + 2 : std::max(right, x + 1);
  }
  return {left, top, right - left, bottom - top};
}

// How far the pixels of a part of the picture are from the nearest border between two labels,
// in half pixels: 1 beside it, kFar from 15 pixels on.
class BorderDistances {
 public:
  static constexpr std::uint8_t kFar = 31;

  BorderDistances(const Silhouette& silhouette, const Part& part)
      : stride_(part.width + 2 * kMargin),
        rows_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(part.height + 2), kFar),
        other_(static_cast<std::size_t>(stride_), kFar) {
    for (int y = 0; y < part.height; ++y) {
      mark_borders(silhouette, part, y);
      spread<-1>(y, part.width);
    }
    for (int y = part.height - 1; y >= 0; --y) spread<1>(y, part.width);
  }

  const std::uint8_t* row(int y) const { return rows_.data() + offset(y); }

 private:
  static constexpr int kMargin = 16;  // columns beside the part, which are far

  std::size_t offset(int y) const {
    return static_cast<std::size_t>(stride_) * static_cast<std::size_t>(y + 1) + kMargin;
  }

  void mark_borders(const Silhouette& silhouette, const Part& part, int y) {
    const int v = part.y + y, last = silhouette.width() - 1;
    const std::uint8_t* const here = row_of(silhouette, v) + part.x;
    const std::uint8_t* const above = row_of(silhouette, std::max(0, v - 1)) + part.x;
    const std::uint8_t* const below =
        row_of(silhouette, std::min(silhouette.height() - 1, v + 1)) + part.x;
    std::uint8_t* const distance = rows_.data() + offset(y);
    const auto mark = [=](int x, int left, int right) {
      distance[x] = static_cast<std::uint8_t>((here[x] ^ above[x]) | (here[x] ^ below[x]) |
                                              (here[x] ^ here[left]) | (here[x] ^ here[right]));
    };
    for (int x = 1; x + 1 < part.width; ++x) mark(x, x - 1, x + 1);
    for (const int x : {0, part.width - 1}) {
      mark(x, part.x + x > 0 ? x - 1 : x, part.x + x < last ? x + 1 : x);
    }
    for (int x = 0; x < part.width; ++x) distance[x] = distance[x] != 0 ? std::uint8_t{1} : kFar;
  }

  // Takes on what the row before and the pixels before in the row say: to the right and down
  // for -1, to the left and up for 1.
  template <int kBefore>
  void spread(int y, int width) {
    std::uint8_t* const here = rows_.data() + offset(y);
    const std::uint8_t* const before = rows_.data() + offset(y + kBefore);
    for (int x = 0; x < width; ++x) {
      const std::uint8_t across = std::min(before[x - 1], before[x + 1]);
      const auto over_corner = static_cast<std::uint8_t>(across + 3);
      const auto over_side = static_cast<std::uint8_t>(before[x] + 2);
      here[x] = std::min(here[x], std::min(over_corner, over_side));
    }
    // Along the row by doubled steps.
    std::uint8_t* const other = other_.data() + kMargin;
    const auto step = [width](const std::uint8_t* from, std::uint8_t* to, int pixels) {
      for (int x = 0; x < width; ++x) {
        const auto along = static_cast<std::uint8_t>(from[x + kBefore * pixels] + 2 * pixels);
        to[x] = std::min(from[x], along);
      }
    };
    step(here, other, 1);
    step(other, here, 2);
    step(here, other, 4);
    step(other, here, 8);
  }

  int stride_;
  std::vector<std::uint8_t> rows_;
  std::vector<std::uint8_t> other_;
};

// What the values of a side are taken to change with, for each of BorderDistances' values: the
// depth or its ramp [px or its ramp], as the shading says.
using Ramp = std::array<double, BorderDistances::kFar + 1>;

Ramp make_ramp(Shading shading) {
  Ramp ramp = {};
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    const double depth = 0.5 * static_cast<double>(i);
    // What changes with a constant is nothing.
    ramp[i] = shading == Shading::none ? 1.0 : shading == Shading::round ? std::sqrt(depth) : depth;
  }
  return ramp;
}

// Sums over some pixels of one side: count, the ramp and its square, values, values by the
// ramp, and values by values (lower triangle).
template <int N>
class Sums {
 public:
  void add(double ramp, const float* pixel) {
    sums_[0] += 1.0;
    sums_[1] += ramp;
    sums_[2] += ramp * ramp;
    std::size_t product = 3 + 2 * N;
    for (std::size_t row = 0; row < N; ++row) {
      const double value = static_cast<double>(pixel[row]);
      sums_[3 + row] += value;
      sums_[3 + N + row] += value * ramp;
      for (std::size_t column = 0; column <= row; ++column) {
        sums_[product++] += value * static_cast<double>(pixel[column]);
      }
    }
  }
  void add(const Sums& other) {
    for (std::size_t i = 0; i < kSize; ++i) sums_[i] += other.sums_[i];
  }

  double count() const { return sums_[0]; }
  double mean_ramp() const { return sums_[1] / count(); }
  Levels<N> mean() const { return Eigen::Map<const Levels<N>>(sums_.data() + 3) / count(); }
  // By which the values change with the ramp. Where the pixels are all at much the same distance,
  // it is nearer to nothing.
  Levels<N> slope() const {
    constexpr double kLeastSpread = 0.01;  // of the mean's square
    return covariance() / (ramp_scatter() + kLeastSpread * count() * mean_ramp() * mean_ramp());
  }
  // The sum of r r^T, where r is what the slope leaves of the values.
  Eigen::Matrix<double, N, N> scatter() const {
    Eigen::Matrix<double, N, N> products;
    std::size_t i = 3 + 2 * N;
    for (int row = 0; row < N; ++row) {
      for (int column = 0; column <= row; ++column) {
        products(row, column) = products(column, row) = sums_[i++];
      }
    }
    const Levels<N> by = slope(), with = covariance();
    return products - count() * mean() * mean().transpose() - by * with.transpose() -
           with * by.transpose() + ramp_scatter() * by * by.transpose();
  }

 private:
  // Rounded up, as two sums are added at a time.
  static constexpr std::size_t kSize = (4 + 2 * N + N * (N + 1) / 2) / 2 * 2;

  double ramp_scatter() const { return sums_[2] - count() * mean_ramp() * mean_ramp(); }
  Levels<N> covariance() const {
    return Eigen::Map<const Levels<N>>(sums_.data() + 3 + N) - sums_[1] * mean();
  }

  std::array<double, kSize> sums_ = {};
};

// What tells the two sides of a border apart in one place. `ramp` is negative on the
// background's side.
template <int N>
struct Divide {
  Divide() = default;
  Divide(const Sums<N>& hand, const Sums<N>& background, double noise) {
    if (hand.count() < 0.5 || background.count() < 0.5) return;
    has_both = true;
    const Levels<N> of_hand = hand.slope(), of_background = background.slope();
    const Levels<N> high = hand.mean() - hand.mean_ramp() * of_hand;
    const Levels<N> low = background.mean() - background.mean_ramp() * of_background;
    const Levels<N> step = high - low;
    Eigen::Matrix<double, N, N> spread =
        (hand.scatter() + background.scatter()) / (hand.count() + background.count());
    spread.diagonal().array() += noise * noise;
    direction = spread.inverse() * step;
    contrast = step[0];
    // What the slopes alone make of it is no border.
    if (direction.dot(hand.mean() - background.mean()) <= 0.0) return;
    apart = direction.dot(step);
    middle = 0.5 * direction.dot(high + low);
    hand_slope = direction.dot(of_hand);
    background_slope = direction.dot(of_background);
  }

  bool is_clear(double ramp) const {
    constexpr double kLeastDistance = 3.0;  // standard deviations
    const double here = apart + ramp * (ramp > 0.0 ? hand_slope : background_slope);
    return here >= kLeastDistance * kLeastDistance;
  }
  bool is_hand(const float* pixel, double ramp) const {
    const double more = 0.5 * ramp * (ramp > 0.0 ? hand_slope : -background_slope);
    return direction.dot(value_at<N>(pixel)) > middle + more;
  }

  bool has_both = false;
  double contrast = 0.0;
  Levels<N> direction = Levels<N>::Zero();
  // Along the direction: how far the sides are apart at the border (squared, in spreads), what lies
  // half way, and how each changes with the ramp.
  double apart = 0.0, middle = 0.0, hand_slope = 0.0, background_slope = 0.0;
};

// The two sides of the borders in a part of the picture, summed over square cells of which
// windows are made.
template <int N>
class Sides {
 public:
  Sides(const Image<float>& picture, const Silhouette& silhouette, const Part& part,
        const BorderDistances& distances, const Ramp& ramp, const BorderOptions& options)
      : reach_(options.reach_px / kCell),
        columns_((part.width + kCell - 1) / kCell),
        rows_((part.height + kCell - 1) / kCell),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    const int nearest = 2 * options.clearance_px;
    // Every other row is enough.
    for (int y = 0; y < part.height; y += 2) {
      const std::uint8_t* const distance = distances.row(y);
      const std::uint8_t* const labels = row_of(silhouette, part.y + y) + part.x;
      const float* const values = &picture(part.x, part.y + y);
      TwoSides* const cells = &cells_[static_cast<std::size_t>(y / kCell * columns_)];
      for (int x = 0; x < part.width; ++x) {
        if (distance[x] <= nearest || distance[x] >= BorderDistances::kFar) continue;
        if (labels[x] == kUnknown) continue;
        TwoSides& cell = cells[x / kCell];
        (labels[x] == kHand ? cell.hand : cell.background).add(ramp[distance[x]], values + N * x);
      }
    }
  }

  // What tells them apart around a pixel of the part.
  const Divide<N>& around(int x, int y, double noise) {
    if (divides_.empty()) divides_.resize(cells_.size());
    const int column = x / kCell, row = y / kCell;
    auto& [is_known, divide] = divides_[static_cast<std::size_t>(row * columns_ + column)];
    if (!is_known) {
      TwoSides sum;
      for (int v = std::max(0, row - reach_); v <= std::min(rows_ - 1, row + reach_); ++v) {
        for (int u = std::max(0, column - reach_); u <= std::min(columns_ - 1, column + reach_);
             ++u) {
          const TwoSides& cell = cells_[static_cast<std::size_t>(v * columns_ + u)];
          sum.hand.add(cell.hand);
          sum.background.add(cell.background);
        }
      }
      divide = Divide<N>(sum.hand, sum.background, noise);
      is_known = true;
    }
    return divide;
  }

 private:
  static constexpr int kCell = 6;  // [px]
  struct TwoSides {
    Sums<N> hand, background;
  };

  int reach_, columns_, rows_;  // in cells
  std::vector<TwoSides> cells_;
  std::vector<std::pair<bool, Divide<N>>> divides_;
};

template <int N>
BorderReport move_border(const Image<float>& picture, double noise, const BorderOptions& options,
                         Silhouette& silhouette) {
  const Part border = box_of_borders(silhouette);
  if (border.width == 0) return {};
  const Part part = grown(border, options.reach_px + options.clearance_px, silhouette);
  const BorderDistances distances(silhouette, part);
  const Ramp ramp = make_ramp(options.shading);
  Sides<N> sides(picture, silhouette, part, distances, ramp, options);
  BorderReport report;
  const int nearest = 2 * options.clearance_px;
  double visited = 0.0;
  for (int y = 0; y < part.height; ++y) {
    const std::uint8_t* const distance = distances.row(y);
    PixelLabel* const labels = &silhouette(part.x, part.y + y);
    const float* const values = &picture(part.x, part.y + y);
    for (int x = 0; x < part.width; ++x) {
      while (x < part.width && distance[x] > nearest) ++x;
      if (x == part.width) break;
      if (labels[x] == PixelLabel::unknown) continue;
      const Divide<N>& divide = sides.around(x, y, noise);
      if (!divide.has_both) continue;
      visited += 1.0;
      report.contrast += divide.contrast;
      const double here = (labels[x] == PixelLabel::hand ? 1.0 : -1.0) * ramp[distance[x]];
      if (!divide.is_clear(here)) continue;
      report.clear_share += 1.0;
      labels[x] = divide.is_hand(values + N * x, here) ? PixelLabel::hand : PixelLabel::background;
    }
  }
  if (visited == 0.0) return {};
  report.contrast /= visited;
  report.clear_share /= visited;
  return report;
}

void check_sizes(const Image<float>& picture, const Silhouette& silhouette) {
  if (picture.width() == silhouette.width() && picture.height() == silhouette.height() &&
      (picture.channels() == 1 || picture.channels() == 3)) {
    return;
  }
  throw Error("border: got a picture of ", picture.width(), " x ", picture.height(), " with ",
              picture.channels(), " channels, expected ", silhouette.width(), " x ",
              silhouette.height(), " with 1 or 3");
}

}  // namespace

BorderReport move_border_to_half_height(const Image<float>& picture, double noise,
                                        const BorderOptions& options, Silhouette& silhouette) {
  check_sizes(picture, silhouette);
  return picture.channels() == 1 ? move_border<1>(picture, noise, options, silhouette)
                                 : move_border<3>(picture, noise, options, silhouette);
}

}  // namespace tegata
