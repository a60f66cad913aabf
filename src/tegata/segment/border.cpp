// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// R. A. Fisher: The Use of Multiple Measurements in Taxonomic Problems. Annals of Eugenics 7, 1936:
// the direction in which two classes with a common spread S and means a, b are told apart best is
// S^-1 (a - b).
#include "tegata/segment/border.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <opencv2/imgproc.hpp>
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

// Count, sum and sums of products (lower triangle) of values.
template <int N>
class Moments {
 public:
  void add(const float* pixel) { add_times(1.0, pixel); }
  void remove(const float* pixel) { add_times(-1.0, pixel); }
  void set_to_sum(const Moments& a, const Moments& b) {
    for (std::size_t i = 0; i < kSize; ++i) sums_[i] = a.sums_[i] + b.sums_[i];
  }
  void set_to_difference(const Moments& a, const Moments& b) {
    for (std::size_t i = 0; i < kSize; ++i) sums_[i] = a.sums_[i] - b.sums_[i];
  }

  double count() const { return sums_[0]; }
  Levels<N> mean() const { return Eigen::Map<const Levels<N>>(sums_.data() + 1) / count(); }
  // The sum of (value - mean) (value - mean)^T.
  Eigen::Matrix<double, N, N> scatter() const {
    Eigen::Matrix<double, N, N> products;
    std::size_t i = 1 + N;
    for (int row = 0; row < N; ++row) {
      for (int column = 0; column <= row; ++column) {
        products(row, column) = products(column, row) = sums_[i++];
      }
    }
    return products - count() * mean() * mean().transpose();
  }

 private:
  // Rounded up, as two sums are added at a time.
  static constexpr std::size_t kSize = (2 + N + N * (N + 1) / 2) / 2 * 2;

  void add_times(double sign, const float* pixel) {
    sums_[0] += sign;
    std::size_t i = 1 + N;
    for (int row = 0; row < N; ++row) {
      const double value = sign * static_cast<double>(pixel[row]);
      sums_[static_cast<std::size_t>(1 + row)] += value;
      for (int column = 0; column <= row; ++column) {
        sums_[i++] += value * static_cast<double>(pixel[column]);
      }
    }
  }

  std::array<double, kSize> sums_ = {};
};

// Grown by `margin` pixels on each side, but not over the edge of the picture.
cv::Rect grown(const cv::Rect& box, int margin, const Silhouette& silhouette) {
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
         cv::Rect(0, 0, silhouette.width(), silhouette.height());
}

bool are_equal(const PixelLabel* a, const PixelLabel* b, int count) {
  return std::memcmp(a, b, static_cast<std::size_t>(count)) == 0;
}

// The box of all pixels with another label than their neighbour's on the right or below, and of
// these neighbours.
cv::Rect box_of_borders(const Silhouette& silhouette) {
  const int width = silhouette.width(), height = silhouette.height();
  const PixelLabel* const labels = silhouette.values().data();
  int left = width, right = 0, top = height, bottom = 0;
  // The columns in which two stretches of labels differ belong to the box.
  const auto add_differences = [&](const PixelLabel* a, const PixelLabel* b, int count, int extra) {
    left = std::min(left, static_cast<int>(std::mismatch(a, a + count, b).first - a));
    int last = count;
    while (last > right && a[last - 1] == b[last - 1]) --last;
    right = std::max(right, last + extra);
  };
  for (int y = 0; y < height; ++y) {
    const PixelLabel* const row = labels + static_cast<std::ptrdiff_t>(y) * width;
    const bool across = !are_equal(row, row + 1, width - 1);
    const bool down = y + 1 < height && !are_equal(row, row + width, width);
    if (across) add_differences(row, row + 1, width - 1, 1);
    if (down) add_differences(row, row + width, width, 0);
    if (!across && !down) continue;
    top = std::min(top, y);
    bottom = std::max(bottom, down ? y + 2 : y + 1);
  }
  return right <= left ? cv::Rect() : cv::Rect(left, top, right - left, bottom - top);
}

// Which pixels of a part of the picture belong to which side for sure (255, else 0).
struct SurePixels {
  SurePixels(const Silhouette& silhouette, const cv::Rect& part, const BorderOptions& options)
      : labels(silhouette.height(), silhouette.width(), CV_8U,
               // Only read from.
               const_cast<PixelLabel*>(silhouette.values().data())),
        hand(of(PixelLabel::hand, part, options)),
        background(of(PixelLabel::background, part, options)) {}

  cv::Mat labels, hand, background;

 private:
  cv::Mat of(PixelLabel label, const cv::Rect& part, const BorderOptions& options) const {
    cv::Mat mask, sure;
    cv::compare(labels(part), static_cast<double>(label), mask, cv::CMP_EQ);
    const int breadth = 2 * options.clearance_px + 1;
    cv::erode(mask, sure, cv::getStructuringElement(cv::MORPH_ELLIPSE, {breadth, breadth}));
    return sure;
  }
};

// The moments of one side's sure pixels over square windows, row by row from the top of a part of
// the picture. Every other row is enough. Positions are within the part.
template <int N>
class Side {
 public:
  Side(const Image<float>& picture, const cv::Mat& sure, const cv::Rect& part, int reach)
      : picture_(picture),
        sure_(sure),
        part_(part),
        reach_(reach),
        columns_(static_cast<std::size_t>(part.width)),
        sums_(columns_.size() + 1) {}

  void go_to_row(int y) {
    bool has_changed = false;
    for (; bottom_ < std::min(part_.height, y + reach_ + 1); bottom_ += kRowStep) {
      each_sure(bottom_, [&](std::size_t x, const float* pixel) { columns_[x].add(pixel); });
      has_changed = true;
    }
    for (; top_ < y - reach_; top_ += kRowStep) {
      each_sure(top_, [&](std::size_t x, const float* pixel) { columns_[x].remove(pixel); });
      has_changed = true;
    }
    if (!has_changed) return;
    for (std::size_t x = 0; x < columns_.size(); ++x) {
      sums_[x + 1].set_to_sum(sums_[x], columns_[x]);
    }
  }
  Moments<N> around(int x) const {
    Moments<N> moments;
    moments.set_to_difference(
        sums_[static_cast<std::size_t>(std::min(part_.width, x + reach_ + 1))],
        sums_[static_cast<std::size_t>(std::max(0, x - reach_))]);
    return moments;
  }

 private:
  template <typename Visit>
  void each_sure(int y, const Visit& visit) {
    const std::uint8_t* const sure = sure_.ptr<std::uint8_t>(y);
    const float* pixel = &picture_(part_.x, part_.y + y);
    for (std::size_t x = 0; x < columns_.size(); ++x, pixel += N) {
      if (sure[x] != 0) visit(x, pixel);
    }
  }

  static constexpr int kRowStep = 2;

  const Image<float>& picture_;
  cv::Mat sure_;
  cv::Rect part_;
  int reach_;
  int top_ = 0, bottom_ = 0;  // first row in the columns' moments, first one not in them
  std::vector<Moments<N>> columns_;
  std::vector<Moments<N>> sums_;  // of the columns before each
};

// Calls visit(x, y, moments of the hand, of the background) for each pixel near the border that has
// both sides in reach.
template <int N, typename Visit>
void visit_border(const Image<float>& picture, const BorderOptions& options,
                  const Silhouette& silhouette, const Visit& visit) {
  const cv::Rect border = box_of_borders(silhouette);
  if (border.empty()) return;
  const cv::Rect near = grown(border, options.clearance_px, silhouette);
  const cv::Rect part = grown(near, options.reach_px, silhouette);
  const SurePixels sure(silhouette, part, options);
  Side<N> hand(picture, sure.hand, part, options.reach_px);
  Side<N> background(picture, sure.background, part, options.reach_px);
  for (int y = near.y; y < near.y + near.height; ++y) {
    hand.go_to_row(y - part.y);
    background.go_to_row(y - part.y);
    const std::uint8_t* const sure_hand = sure.hand.ptr<std::uint8_t>(y - part.y);
    const std::uint8_t* const sure_background = sure.background.ptr<std::uint8_t>(y - part.y);
    for (int x = near.x; x < near.x + near.width; ++x) {
      const int i = x - part.x;
      if ((sure_hand[i] | sure_background[i]) != 0) continue;
      if (silhouette(x, y) == PixelLabel::unknown) continue;
      const Moments<N> on_hand = hand.around(i), behind = background.around(i);
      if (on_hand.count() > 0.5 && behind.count() > 0.5) visit(x, y, on_hand, behind);
    }
  }
}

template <int N>
BorderReport move_border(const Image<float>& picture, double noise, const BorderOptions& options,
                         Silhouette& silhouette) {
  constexpr double kLeastDistance = 3.0;  // standard deviations
  const Silhouette before = silhouette;
  BorderReport report;
  double visited = 0.0;
  visit_border<N>(picture, options, before,
                  [&](int x, int y, const Moments<N>& hand, const Moments<N>& background) {
                    const Levels<N> high = hand.mean(), low = background.mean(), step = high - low;
                    report.contrast += step[0];
                    visited += 1.0;
                    Eigen::Matrix<double, N, N> spread = (hand.scatter() + background.scatter()) /
                                                         (hand.count() + background.count());
                    spread.diagonal().array() += noise * noise;
                    const Levels<N> direction = spread.inverse() * step;
                    if (!(direction.dot(step) >= kLeastDistance * kLeastDistance)) return;
                    report.clear_share += 1.0;
                    const Levels<N> value = value_at<N>(&picture(x, y));
                    const bool is_hand = direction.dot(value - 0.5 * (high + low)) > 0.0;
                    silhouette(x, y) = is_hand ? PixelLabel::hand : PixelLabel::background;
                  });
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
