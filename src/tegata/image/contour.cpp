// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/contour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tegata {
namespace {

// [px] Blurs of the hand's pixels. Where the border is curved, half of a blur's surrounding is
// reached too far inwards by curvature * blur^2 / 2; two blurs tell how far.
constexpr double kNarrowBlur = 1.5;
constexpr double kWideBlur = 2.0;
constexpr int kClearance = 2;           // [px] to the next unknown pixel and to the picture's edge
constexpr int kReach = 6;               // [px] of the blur
constexpr double kLongestShift = 0.75;  // [px]

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

// The share of hand around a position under a Gaussian window, and its gradient. Unknown pixels and
// what lies outside the picture have no weight.
struct Share {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
};

Share hand_share(const Silhouette& silhouette, const Eigen::Vector2d& position, double sigma) {
  const double falloff = 0.5 / (sigma * sigma);
  const int column = static_cast<int>(std::floor(position.x()));
  const int row = static_cast<int>(std::floor(position.y()));
  const int left = std::max(0, column - kReach + 1);
  const int right = std::min(silhouette.width() - 1, column + kReach);
  const int top = std::max(0, row - kReach + 1);
  const int bottom = std::min(silhouette.height() - 1, row + kReach);
  std::array<double, 2 * kReach> weight_x;
  for (int x = left; x <= right; ++x) {
    const double step = x - position.x();
    weight_x[static_cast<std::size_t>(x - left)] = std::exp(-falloff * step * step);
  }
  double sum = 0.0, hand = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero(), hand_moment = Eigen::Vector2d::Zero();
  for (int y = top; y <= bottom; ++y) {
    const double step_y = y - position.y();
    const double weight_y = std::exp(-falloff * step_y * step_y);
    for (int x = left; x <= right; ++x) {
      const PixelLabel label = silhouette(x, y);
      if (label == PixelLabel::unknown) continue;
      const double weight = weight_x[static_cast<std::size_t>(x - left)] * weight_y;
      const Eigen::Vector2d weighted = weight * Eigen::Vector2d(x - position.x(), step_y);
      sum += weight;
      moment += weighted;
      if (label != PixelLabel::hand) continue;
      hand += weight;
      hand_moment += weighted;
    }
  }
  const double share = hand / sum;
  return {share, (hand_moment - share * moment) * (2.0 * falloff / sum)};
}

ContourPoint smooth_point(const Silhouette& silhouette, const Crack& crack) {
  const Eigen::Vector2d along(crack.dx, crack.dy);
  const Eigen::Vector2d outward = crack.hand_first ? along : Eigen::Vector2d(-along);
  const Eigen::Vector2d middle = Eigen::Vector2d(crack.x, crack.y) + 0.5 * along;
  ContourPoint point{middle, outward};
  // Newton's method along the gradient to where half of the surrounding is hand.
  for (int i = 0; i < 2; ++i) {
    const Share share = hand_share(silhouette, point.pixel, kNarrowBlur);
    const double slope = share.gradient.squaredNorm();
    if (slope < 1e-3) break;  // a structure of a pixel's width; a straight edge has 0.07
    point.pixel -= (share.value - 0.5) / slope * share.gradient;
  }
  const Share wide = hand_share(silhouette, point.pixel, kWideBlur);
  const double slope = wide.gradient.norm();
  if (slope > 0.01) {
    point.normal = -wide.gradient / slope;
    constexpr double kExtrapolation =
        kNarrowBlur * kNarrowBlur / (kWideBlur * kWideBlur - kNarrowBlur * kNarrowBlur);
    point.pixel += kExtrapolation * (0.5 - wide.value) / slope * point.normal;
  }
  const Eigen::Vector2d shift = point.pixel - middle;
  if (shift.norm() > kLongestShift) point.pixel = middle + shift.normalized() * kLongestShift;
  return point;
}

}  // namespace

std::vector<ContourPoint> silhouette_contour(const Silhouette& silhouette) {
  std::vector<ContourPoint> contour;
  const auto visit = [&](int x, int y, int dx, int dy) {
    if (!silhouette.contains(x + dx, y + dy)) return;
    const PixelLabel first = silhouette(x, y), second = silhouette(x + dx, y + dy);
    if (first == second || first == PixelLabel::unknown || second == PixelLabel::unknown) return;
    const Crack crack{x, y, dx, dy, first == PixelLabel::hand};
    if (is_clear(silhouette, crack)) contour.push_back(smooth_point(silhouette, crack));
  };
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      visit(x, y, 1, 0);
      visit(x, y, 0, 1);
    }
  }
  return contour;
}

}  // namespace tegata
