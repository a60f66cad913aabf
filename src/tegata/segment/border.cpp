// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// R. A. Fisher: The Use of Multiple Measurements in Taxonomic Problems. Annals of Eugenics 7, 1936:
// the direction in which two classes with a common spread S and means a, b are told apart best is
// S^-1 (a - b).
#include "tegata/segment/border.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tegata/base/error.h"

namespace tegata {
namespace {

template <int N>
using Levels = Eigen::Matrix<double, N, 1>;

template <int N>
Levels<N> value_at(const Image<float>& picture, int x, int y) {
  Levels<N> value;
  for (int c = 0; c < N; ++c) value[c] = picture(x, y, c);
  return value;
}

// Count, sum and sum of products of values.
template <int N>
struct Moments {
  double count = 0.0;
  Levels<N> sum = Levels<N>::Zero();
  Eigen::Matrix<double, N, N> products = Eigen::Matrix<double, N, N>::Zero();

  void add(double sign, const Levels<N>& value) {
    count += sign;
    sum += sign * value;
    products += sign * value * value.transpose();
  }
  Moments& operator+=(const Moments& other) {
    count += other.count;
    sum += other.sum;
    products += other.products;
    return *this;
  }
  Moments& operator-=(const Moments& other) {
    count -= other.count;
    sum -= other.sum;
    products -= other.products;
    return *this;
  }
  Levels<N> mean() const { return sum / count; }
  // The sum of (value - mean) (value - mean)^T.
  Eigen::Matrix<double, N, N> scatter() const { return products - sum * sum.transpose() / count; }
};

// The pixels of a label that are clear of the border: 0 or 255.
cv::Mat sure_pixels(const Silhouette& silhouette, PixelLabel label, const BorderOptions& options) {
  cv::Mat mask(silhouette.height(), silhouette.width(), CV_8U), sure;
  std::transform(silhouette.values().begin(), silhouette.values().end(), mask.begin<std::uint8_t>(),
                 [&](PixelLabel l) { return static_cast<std::uint8_t>(l == label ? 255 : 0); });
  const int breadth = 2 * options.clearance_px + 1;
  cv::erode(mask, sure, cv::getStructuringElement(cv::MORPH_ELLIPSE, {breadth, breadth}));
  return sure;
}

// The moments of one side's sure pixels over square windows around the pixels of a part of the
// picture, row by row from its top.
template <int N>
class Side {
 public:
  Side(const Image<float>& picture, const cv::Mat& sure, const cv::Rect& part, int reach)
      : picture_(picture),
        sure_(sure),
        reach_(reach),
        left_(std::max(0, part.x - reach)),
        right_(std::min(sure.cols, part.x + part.width + reach)),
        top_(std::max(0, part.y - reach)),
        bottom_(top_),
        columns_(static_cast<std::size_t>(right_ - left_)),
        sums_(columns_.size() + 1) {}

  void go_to_row(int y) {
    for (; bottom_ < std::min(sure_.rows, y + reach_ + 1); ++bottom_) add_row(bottom_, 1.0);
    for (; top_ < y - reach_; ++top_) add_row(top_, -1.0);
    for (std::size_t x = 0; x < columns_.size(); ++x) {
      sums_[x + 1] = sums_[x];
      sums_[x + 1] += columns_[x];
    }
  }
  Moments<N> around(int x) const {
    Moments<N> moments = sums_[static_cast<std::size_t>(std::min(right_, x + reach_ + 1) - left_)];
    moments -= sums_[static_cast<std::size_t>(std::max(left_, x - reach_) - left_)];
    return moments;
  }

 private:
  void add_row(int y, double sign) {
    for (int x = left_; x < right_; ++x) {
      if (sure_.at<std::uint8_t>(y, x) == 0) continue;
      columns_[static_cast<std::size_t>(x - left_)].add(sign, value_at<N>(picture_, x, y));
    }
  }

  const Image<float>& picture_;
  cv::Mat sure_;
  int reach_, left_, right_;
  int top_, bottom_;  // the rows that the columns' moments cover, without the last
  std::vector<Moments<N>> columns_;
  std::vector<Moments<N>> sums_;  // of the columns before each
};

// Calls visit(x, y, moments of the hand, of the background) for each pixel near the border that has
// both sides in reach.
template <int N, typename Visit>
void visit_border(const Image<float>& picture, const BorderOptions& options,
                  const Silhouette& silhouette, const Visit& visit) {
  const cv::Mat sure_hand = sure_pixels(silhouette, PixelLabel::hand, options);
  const cv::Mat sure_background = sure_pixels(silhouette, PixelLabel::background, options);
  const cv::Mat doubtful = (sure_hand | sure_background) == 0;
  const cv::Rect part = cv::boundingRect(doubtful);
  Side<N> hand(picture, sure_hand, part, options.reach_px);
  Side<N> background(picture, sure_background, part, options.reach_px);
  for (int y = part.y; y < part.y + part.height; ++y) {
    hand.go_to_row(y);
    background.go_to_row(y);
    for (int x = part.x; x < part.x + part.width; ++x) {
      if (doubtful.at<std::uint8_t>(y, x) == 0 || silhouette(x, y) == PixelLabel::unknown) continue;
      const Moments<N> on_hand = hand.around(x), behind = background.around(x);
      if (on_hand.count > 0.5 && behind.count > 0.5) visit(x, y, on_hand, behind);
    }
  }
}

template <int N>
void move_border(const Image<float>& picture, double noise, const BorderOptions& options,
                 Silhouette& silhouette) {
  constexpr double kLeastDistance = 3.0;  // standard deviations
  const Silhouette before = silhouette;
  visit_border<N>(picture, options, before,
                  [&](int x, int y, const Moments<N>& hand, const Moments<N>& background) {
                    const Levels<N> high = hand.mean(), low = background.mean(), step = high - low;
                    Eigen::Matrix<double, N, N> spread =
                        (hand.scatter() + background.scatter()) / (hand.count + background.count);
                    spread.diagonal().array() += noise * noise;
                    const Levels<N> direction = spread.ldlt().solve(step);
                    if (!(direction.dot(step) >= kLeastDistance * kLeastDistance)) return;
                    const bool is_hand =
                        direction.dot(value_at<N>(picture, x, y) - 0.5 * (high + low)) > 0.0;
                    silhouette(x, y) = is_hand ? PixelLabel::hand : PixelLabel::background;
                  });
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

void move_border_to_half_height(const Image<float>& picture, double noise,
                                const BorderOptions& options, Silhouette& silhouette) {
  check_sizes(picture, silhouette);
  if (picture.channels() == 1) {
    move_border<1>(picture, noise, options, silhouette);
  } else {
    move_border<3>(picture, noise, options, silhouette);
  }
}

double border_contrast(const Image<float>& picture, const BorderOptions& options,
                       const Silhouette& silhouette) {
  check_sizes(picture, silhouette);
  double sum = 0.0;
  std::size_t count = 0;
  visit_border<1>(picture, options, silhouette,
                  [&](int, int, const Moments<1>& hand, const Moments<1>& background) {
                    sum += hand.mean()[0] - background.mean()[0];
                    ++count;
                  });
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace tegata
