// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tegata/image/pixel_box.h"

namespace tegata {
namespace {

constexpr int kClearance = 2;           // [px] to the next unknown pixel and to the picture's edge
constexpr int kReach = 6;               // [px] of the blur
constexpr int kWindow = 2 * kReach;     // [px] columns and rows that a blur asks
constexpr double kLongestShift = 0.75;  // [px]

using Lanes = Eigen::Array<float, kWindow, 1>;

// A Gaussian window about a position that lies 0 to 1 beyond a pixel, up to a common factor:
// exp(-(i - f)^2 / 2 sigma^2) = exp(-i^2 / 2 sigma^2) exp(f / sigma^2)^i exp(-f^2 / 2 sigma^2).
class Blur {
 public:
  explicit Blur(double standard_deviation) : sigma(standard_deviation) {
    for (int i = 0; i < kWindow; ++i) {
      const double step = i + kFirst;
      at_pixel_[static_cast<std::size_t>(i)] = std::exp(-0.5 * step * step / (sigma * sigma));
    }
  }
  Lanes weights(double beyond) const {
    const double ratio = std::exp(beyond / (sigma * sigma));
    double power = std::exp(kFirst * beyond / (sigma * sigma));
    Lanes result;
    for (int i = 0; i < kWindow; ++i) {
      result[i] = static_cast<float>(at_pixel_[static_cast<std::size_t>(i)] * power);
      power *= ratio;
    }
    return result;
  }

  static constexpr int kFirst = 1 - kReach;  // the window's first pixel
  double sigma;                              // [px]

 private:
  std::array<double, kWindow> at_pixel_;
};

// Blurs of the hand's pixels. Where the border is curved, half of a blur's surrounding is reached
// too far inwards by curvature * blur^2 / 2; two blurs tell how far.
struct Blurs {
  Blur narrow = Blur(1.5), wide = Blur(2.0);
};

// A border between two neighbouring pixels.
struct Crack {
  int x, y;         // the left or upper of the two
  int dx, dy;       // to the other one
  bool hand_first;  // whether (x, y) is the hand's
};

bool is_clear(const Silhouette& silhouette, const Crack& crack) {
  const int left = crack.x - kClearance, right = crack.x + crack.dx + kClearance;
  const int top = crack.y - kClearance, bottom = crack.y + crack.dy + kClearance;
  if (!silhouette.contains(left, top) || !silhouette.contains(right, bottom)) return false;
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      if (silhouette(x, y) == PixelLabel::unknown) return false;
    }
  }
  return true;
}

// What is known and what is hand, as 0 and 1, where a blur of the hand's border asks; what lies
// outside the picture is not known.
class Labels {
 public:
  // `box` is that of the hand.
  Labels(const Silhouette& silhouette, const PixelBox& box) {
    if (box.empty()) return;
    constexpr int kMargin = kReach + 2;
    left_ = box.left - kMargin, top_ = box.top - kMargin;
    const int right = box.right + kMargin, bottom = box.bottom + kMargin;
    known_ = hand_ = Image<float>(right - left_ + 1, bottom - top_ + 1);
    for (int y = std::max(0, top_); y <= std::min(bottom, silhouette.height() - 1); ++y) {
      for (int x = std::max(0, left_); x <= std::min(right, silhouette.width() - 1); ++x) {
        const PixelLabel label = silhouette(x, y);
        known_(x - left_, y - top_) = label == PixelLabel::unknown ? 0.0F : 1.0F;
        hand_(x - left_, y - top_) = label == PixelLabel::hand ? 1.0F : 0.0F;
      }
    }
  }
  // The kWindow values from there to the right.
  Eigen::Map<const Lanes> known(int x, int y) const {
    return Eigen::Map<const Lanes>(&known_(x - left_, y - top_));
  }
  Eigen::Map<const Lanes> hand(int x, int y) const {
    return Eigen::Map<const Lanes>(&hand_(x - left_, y - top_));
  }

 private:
  int left_ = 0, top_ = 0;
  Image<float> known_, hand_;
};

// The share of hand around a position under a Gaussian window, and its gradient. Unknown pixels and
// what lies outside the picture have no weight.
struct Share {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
};

Share hand_share(const Labels& labels, const Eigen::Vector2d& position, const Blur& blur) {
  const int column = static_cast<int>(std::floor(position.x()));
  const int row = static_cast<int>(std::floor(position.y()));
  const int left = column + Blur::kFirst, top = row + Blur::kFirst;
  const Lanes weights_x = blur.weights(position.x() - column);
  const Lanes weights_y = blur.weights(position.y() - row);
  // Sums along the window's columns, each with the weights of the rows alone.
  Lanes known = Lanes::Zero(), hand = known, known_y = known, hand_y = known;
  for (int j = 0; j < kWindow; ++j) {
    const float weight = weights_y[j];
    const float moment = weight * static_cast<float>(top + j - position.y());
    known += weight * labels.known(left, top + j);
    known_y += moment * labels.known(left, top + j);
    hand += weight * labels.hand(left, top + j);
    hand_y += moment * labels.hand(left, top + j);
  }
  const Lanes steps = Lanes::LinSpaced(static_cast<float>(left - position.x()),
                                       static_cast<float>(left + kWindow - 1 - position.x()));
  const Lanes moments_x = weights_x * steps;
  const double sum = (weights_x * known).sum(), hand_sum = (weights_x * hand).sum();
  const Eigen::Vector2d moment((moments_x * known).sum(), (weights_x * known_y).sum());
  const Eigen::Vector2d hand_moment((moments_x * hand).sum(), (weights_x * hand_y).sum());
  const double share = hand_sum / sum;
  return {share, (hand_moment - share * moment) / (sum * blur.sigma * blur.sigma)};
}

void keep_near(const Eigen::Vector2d& middle, double distance, Eigen::Vector2d& position) {
  const Eigen::Vector2d shift = position - middle;
  if (shift.norm() > distance) position = middle + shift.normalized() * distance;
}

ContourPoint smooth_point(const Labels& labels, const Crack& crack, const Blurs& blurs) {
  const Eigen::Vector2d along(crack.dx, crack.dy);
  const Eigen::Vector2d outward = crack.hand_first ? along : Eigen::Vector2d(-along);
  const Eigen::Vector2d middle = Eigen::Vector2d(crack.x, crack.y) + 0.5 * along;
  ContourPoint point{middle, outward};
  // Newton's method along the gradient to where half of the surrounding is hand.
  for (int i = 0; i < 2; ++i) {
    const Share share = hand_share(labels, point.pixel, blurs.narrow);
    const double slope = share.gradient.squaredNorm();
    if (slope < 1e-3) break;  // a structure of a pixel's width; a straight edge has 0.07
    point.pixel -= (share.value - 0.5) / slope * share.gradient;
    keep_near(middle, kLongestShift, point.pixel);
  }
  const Share wide = hand_share(labels, point.pixel, blurs.wide);
  const double slope = wide.gradient.norm();
  if (slope > 0.01) {
    point.normal = -wide.gradient / slope;
    const double narrow = blurs.narrow.sigma * blurs.narrow.sigma;
    const double extrapolation = narrow / (blurs.wide.sigma * blurs.wide.sigma - narrow);
    point.pixel += extrapolation * (0.5 - wide.value) / slope * point.normal;
  }
  keep_near(middle, kLongestShift, point.pixel);
  return point;
}

}  // namespace

std::vector<ContourPoint> silhouette_contour(const Silhouette& silhouette) {
  const int width = silhouette.width(), height = silhouette.height();
  const PixelBox box = bounds_of(silhouette, PixelLabel::hand);
  const Labels labels(silhouette, box);
  const Blurs blurs;
  std::vector<ContourPoint> contour;
  const auto visit = [&](int x, int y, int dx, int dy) {
    const PixelLabel first = silhouette(x, y), second = silhouette(x + dx, y + dy);
    if (first == PixelLabel::unknown || second == PixelLabel::unknown) return;
    const Crack crack{x, y, dx, dy, first == PixelLabel::hand};
    if (is_clear(silhouette, crack)) contour.push_back(smooth_point(labels, crack, blurs));
  };
  // All borders of the hand's are beside one of its pixels.
  for (int y = std::max(0, box.top - 1); y <= box.bottom; ++y) {
    const PixelLabel* row = &silhouette(0, y);
    const PixelLabel* below = y + 1 < height ? row + width : row;
    for (int x = std::max(0, box.left - 1); x <= box.right; ++x) {
      if (x + 1 < width && row[x] != row[x + 1]) visit(x, y, 1, 0);
      if (row[x] != below[x]) visit(x, y, 0, 1);
    }
  }
  return contour;
}

}  // namespace tegata
