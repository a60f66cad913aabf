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
using Spread = Eigen::Matrix<double, N, N>;

// The part of a picture and a silhouette around the hand.
struct Crop {
  cv::Rect window;
  cv::Mat labels;                 // of PixelLabel
  std::vector<cv::Mat> channels;  // of float
};

Crop crop_to_hand(const Image<float>& picture, const BorderOptions& options,
                  const Silhouette& silhouette) {
  if (picture.width() != silhouette.width() || picture.height() != silhouette.height() ||
      (picture.channels() != 1 && picture.channels() != 3)) {
    throw Error("border: got a picture of ", picture.width(), " x ", picture.height(), " with ",
                picture.channels(), " channels, expected ", silhouette.width(), " x ",
                silhouette.height(), " with 1 or 3");
  }
  cv::Mat labels(silhouette.height(), silhouette.width(), CV_8U);
  std::transform(silhouette.values().begin(), silhouette.values().end(),
                 labels.begin<std::uint8_t>(),
                 [](PixelLabel label) { return static_cast<std::uint8_t>(label); });
  Crop crop;
  crop.window = cv::boundingRect(labels == static_cast<int>(PixelLabel::hand));
  const int margin = options.clearance_px + options.reach_px + 1;
  crop.window -= cv::Point(margin, margin);
  crop.window += cv::Size(2 * margin, 2 * margin);
  crop.window &= cv::Rect(0, 0, labels.cols, labels.rows);
  crop.labels = labels(crop.window);
  for (int c = 0; c < picture.channels(); ++c) {
    cv::Mat channel(crop.window.size(), CV_32F);
    for (int y = 0; y < channel.rows; ++y) {
      for (int x = 0; x < channel.cols; ++x) {
        channel.at<float>(y, x) = picture(crop.window.x + x, crop.window.y + y, c);
      }
    }
    crop.channels.push_back(channel);
  }
  return crop;
}

// One side of the border: which pixels are surely its own, and sums over those in reach of a pixel,
// from tables of sums over all that lies above and to the left (Crow 1984).
template <int N>
class Side {
 public:
  Side(const Crop& crop, PixelLabel label, const BorderOptions& options)
      : reach_(options.reach_px) {
    const int breadth = 2 * options.clearance_px + 1;
    cv::erode(crop.labels == static_cast<int>(label), sure_,
              cv::getStructuringElement(cv::MORPH_ELLIPSE, {breadth, breadth}));
    cv::Mat weight;
    sure_.convertTo(weight, CV_64F, 1.0 / 255.0);
    count_ = table(weight);
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
      cv::Mat value;
      crop.channels[i].convertTo(value, CV_64F);
      const cv::Mat weighted = value.mul(weight);
      sums_.push_back(table(weighted));
      for (std::size_t j = 0; j <= i; ++j) {
        crop.channels[j].convertTo(value, CV_64F);
        products_.push_back(table(weighted.mul(value)));
      }
    }
  }

  bool is_sure(int x, int y) const { return sure_.at<std::uint8_t>(y, x) != 0; }
  double count(int x, int y) const { return sum(count_, x, y); }
  Levels<N> level(int x, int y) const {
    Levels<N> mean;
    for (int i = 0; i < N; ++i) mean[i] = sum(sums_[static_cast<std::size_t>(i)], x, y);
    return mean / count(x, y);
  }
  // The sum over the pixels in reach of (value - level) (value - level)^T.
  Spread<N> scatter(int x, int y, const Levels<N>& level) const {
    Spread<N> result;
    std::size_t k = 0;
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j <= i; ++j, ++k) {
        result(i, j) = sum(products_[k], x, y) - count(x, y) * level[i] * level[j];
        result(j, i) = result(i, j);
      }
    }
    return result;
  }

 private:
  static cv::Mat table(const cv::Mat& image) {
    cv::Mat sums;
    cv::integral(image, sums, CV_64F);
    return sums;
  }
  double sum(const cv::Mat& sums, int x, int y) const {
    const int left = std::max(0, x - reach_), right = std::min(sure_.cols, x + reach_ + 1);
    const int top = std::max(0, y - reach_), bottom = std::min(sure_.rows, y + reach_ + 1);
    return sums.at<double>(bottom, right) - sums.at<double>(bottom, left) -
           sums.at<double>(top, right) + sums.at<double>(top, left);
  }

  int reach_;
  cv::Mat sure_, count_;
  std::vector<cv::Mat> sums_, products_;
};

// Calls visit(x, y) for each pixel of the crop near the border that has both sides in reach.
template <int N, typename Visit>
void visit_border(const Crop& crop, const Side<N>& hand, const Side<N>& background,
                  const Visit& visit) {
  for (int y = 0; y < crop.labels.rows; ++y) {
    for (int x = 0; x < crop.labels.cols; ++x) {
      if (crop.labels.at<std::uint8_t>(y, x) == static_cast<int>(PixelLabel::unknown)) continue;
      if (hand.is_sure(x, y) || background.is_sure(x, y)) continue;
      if (hand.count(x, y) > 0.5 && background.count(x, y) > 0.5) visit(x, y);
    }
  }
}

template <int N>
void move_border(const Crop& crop, double noise, const BorderOptions& options,
                 Silhouette& silhouette) {
  constexpr double kLeastDistance = 3.0;  // standard deviations
  const Side<N> hand(crop, PixelLabel::hand, options);
  const Side<N> background(crop, PixelLabel::background, options);
  visit_border(crop, hand, background, [&](int x, int y) {
    const Levels<N> high = hand.level(x, y), low = background.level(x, y), step = high - low;
    Spread<N> spread = hand.scatter(x, y, high) + background.scatter(x, y, low);
    spread /= hand.count(x, y) + background.count(x, y);
    spread.diagonal().array() += noise * noise;
    const Levels<N> direction = spread.ldlt().solve(step);
    if (!(direction.dot(step) >= kLeastDistance * kLeastDistance)) return;
    Levels<N> value;
    for (int i = 0; i < N; ++i)
      value[i] = crop.channels[static_cast<std::size_t>(i)].at<float>(y, x);
    const bool is_hand = direction.dot(value - 0.5 * (high + low)) > 0.0;
    silhouette(crop.window.x + x, crop.window.y + y) =
        is_hand ? PixelLabel::hand : PixelLabel::background;
  });
}

}  // namespace

void move_border_to_half_height(const Image<float>& picture, double noise,
                                const BorderOptions& options, Silhouette& silhouette) {
  const Crop crop = crop_to_hand(picture, options, silhouette);
  if (crop.channels.size() == 1) {
    move_border<1>(crop, noise, options, silhouette);
  } else {
    move_border<3>(crop, noise, options, silhouette);
  }
}

double border_contrast(const Image<float>& picture, const BorderOptions& options,
                       const Silhouette& silhouette) {
  const Crop crop = crop_to_hand(picture, options, silhouette);
  const Side<1> hand(crop, PixelLabel::hand, options);
  const Side<1> background(crop, PixelLabel::background, options);
  double sum = 0.0;
  std::size_t count = 0;
  visit_border(crop, hand, background, [&](int x, int y) {
    sum += hand.level(x, y)[0] - background.level(x, y)[0];
    ++count;
  });
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace tegata
