// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/outline_rays.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tegata {
namespace {

constexpr int kMargin = 2;  // to the picture's edge or to unknown pixels [px]

bool is_hand(const Silhouette& silhouette, int x, int y) {
  return silhouette.contains(x, y) && silhouette(x, y) == PixelLabel::hand;
}

// A hand pixel with two neighbours or more that are.
bool is_supported_hand(const Silhouette& s, int x, int y) {
  return s(x, y) == PixelLabel::hand && is_hand(s, x - 1, y) + is_hand(s, x + 1, y) +
                                                is_hand(s, x, y - 1) + is_hand(s, x, y + 1) >=
                                            2;
}

bool is_cut(const Silhouette& silhouette, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(pixel.x()), y = static_cast<int>(pixel.y());
  for (int v = y - kMargin; v <= y + kMargin; ++v) {
    for (int u = x - kMargin; u <= x + kMargin; ++u) {
      if (!silhouette.contains(u, v) || silhouette(u, v) == PixelLabel::unknown) return true;
    }
  }
  return false;
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d first = b - a, second = c - a;
  return first.x() * second.y() - first.y() * second.x();
}

}  // namespace

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> hull;
  for (const bool upper : {false, true}) {
    const std::size_t base = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();  // where the other half begins
    if (!upper) std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::optional<OutlineRays> outline_rays(const Silhouette& silhouette, const Camera& camera) {
  constexpr std::size_t kFewestPixels = 30;
  std::vector<Eigen::Vector2d> ends;  // the outermost hand pixels of each row
  std::size_t count = 0;              // of pixels, as far as it matters
  for (int y = 0; y < silhouette.height(); ++y) {
    const PixelLabel* const row = &silhouette(0, y);
    const auto begins = static_cast<const PixelLabel*>(std::memchr(
        row, static_cast<int>(PixelLabel::hand), static_cast<std::size_t>(silhouette.width())));
    if (begins == nullptr) continue;
    int first = static_cast<int>(begins - row), last = silhouette.width() - 1;
    while (first <= last && !is_supported_hand(silhouette, first, y)) ++first;
    while (last >= first && !is_supported_hand(silhouette, last, y)) --last;
    if (last < first) continue;
    for (int x = first; x <= last && count < kFewestPixels; ++x) {
      count += is_supported_hand(silhouette, x, y) ? 1 : 0;
    }
    ends.emplace_back(first, y);
    ends.emplace_back(last, y);
  }
  if (count < kFewestPixels) return std::nullopt;
  OutlineRays outline;
  for (const Eigen::Vector2d& pixel : convex_hull(std::move(ends))) {
    outline.rays.push_back(camera.camera_from_world.rotation * pixel_direction(camera, pixel));
    outline.cut.push_back(is_cut(silhouette, pixel));
  }
  return outline;
}

}  // namespace tegata
