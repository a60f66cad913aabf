// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/outline_trace.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tegata {
namespace {

constexpr std::size_t kSpeckEdges = 12;

/// Walks along the edges between pixels with the hand on its right. Corner (x, y) is the top left
/// one of pixel (x, y).
class BorderWalk {
 public:
  explicit BorderWalk(const Silhouette& silhouette)
      : silhouette_(silhouette), is_walked_(silhouette.width(), silhouette.height(), 0) {}

  bool is_hand(int x, int y) const {
    return silhouette_.contains(x, y) && silhouette_(x, y) == PixelLabel::hand;
  }
  /// Whether an unwalked border runs up along the left edge of a pixel.
  bool starts_at(int x, int y) const {
    return is_hand(x, y) && !is_hand(x - 1, y) && is_walked_(x, y) == 0;
  }
  /// The middles of the edges of the border that runs up along the left edge of a pixel.
  Outline walk(int pixel_x, int pixel_y) {
    // Up, right, down, left; for each where the pixels ahead on the left and right lie.
    constexpr std::array<std::array<int, 2>, 4> kStep = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    constexpr std::array<std::array<int, 2>, 4> kLeft = {{{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}};
    constexpr std::array<std::array<int, 2>, 4> kRight = {{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
    Outline outline;
    int x = pixel_x, y = pixel_y + 1;
    std::size_t direction = 0;
    do {
      if (direction == 0) is_walked_(x, y - 1) = 1;
      outline.emplace_back(x - 0.5 + 0.5 * kStep[direction][0],
                           y - 0.5 + 0.5 * kStep[direction][1]);
      x += kStep[direction][0];
      y += kStep[direction][1];
      if (!is_hand(x + kRight[direction][0], y + kRight[direction][1])) {
        direction = (direction + 1) % 4;
      } else if (is_hand(x + kLeft[direction][0], y + kLeft[direction][1])) {
        direction = (direction + 3) % 4;
      }
    } while (x != pixel_x || y != pixel_y + 1 || direction != 0);
    return outline;
  }

 private:
  const Silhouette& silhouette_;
  Image<std::uint8_t> is_walked_;
};

double distance_to_segment(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(along.dot(point - a) / squared, 0.0, 1.0) : 0.0;
  return (point - a - share * along).norm();
}

/// Marks what must stay between two points that do.
void keep_far_points(const Outline& line, std::size_t first, std::size_t last, double tolerance,
                     std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double distance = distance_to_segment(line[i], line[a], line[b % line.size()]);
      if (distance > farthest) {
        farthest = distance;
        at = i;
      }
    }
    if (at == a) continue;
    kept[at] = true;
    open.emplace_back(a, at);
    open.emplace_back(at, b);
  }
}

Outline reduced(const Outline& line, double tolerance) {
  std::size_t opposite = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if ((line[i] - line[0]).squaredNorm() > (line[opposite] - line[0]).squaredNorm()) opposite = i;
  }
  std::vector<bool> kept(line.size(), false);
  kept[0] = kept[opposite] = true;
  keep_far_points(line, 0, opposite, tolerance, kept);
  keep_far_points(line, opposite, line.size(), tolerance, kept);
  Outline fewer;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) fewer.push_back(line[i]);
  }
  return fewer;
}

}  // namespace

std::vector<Outline> trace_outlines(const Silhouette& silhouette, double tolerance_px) {
  BorderWalk border(silhouette);
  std::vector<Outline> outlines;
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      if (!border.starts_at(x, y)) continue;
      const Outline outline = border.walk(x, y);
      if (outline.size() >= kSpeckEdges) outlines.push_back(reduced(outline, tolerance_px));
    }
  }
  return outlines;
}

}  // namespace tegata
