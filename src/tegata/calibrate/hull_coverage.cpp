// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/hull_coverage.h"

#include <algorithm>
#include <cmath>

namespace tegata {
namespace {

constexpr std::size_t kPixels = 150;  // of each view
constexpr int kDepths = 400;

// Pixels of the hand, evenly over the silhouette.
std::vector<Eigen::Vector2d> sampled_pixels(const Silhouette& silhouette) {
  const std::size_t count = count_pixels(silhouette, PixelLabel::hand);
  const std::size_t step = std::max<std::size_t>(1, count / kPixels);
  std::vector<Eigen::Vector2d> pixels;
  std::size_t seen = 0;
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      if (silhouette(x, y) == PixelLabel::hand && seen++ % step == step / 2) {
        pixels.emplace_back(x, y);
      }
    }
  }
  return pixels;
}

// Whether no view shows background at a point, and at least one besides `from` sees it.
bool is_possible(const std::vector<HullView>& views, std::size_t from,
                 const Eigen::Vector3d& point) {
  bool seen = false;
  for (std::size_t v = 0; v < views.size(); ++v) {
    if (v == from) continue;
    const auto pixel = project(views[v].camera, point);
    if (!pixel) return false;
    if (!views[v].camera.contains(*pixel)) continue;
    seen = true;
    const int x = static_cast<int>(std::floor(pixel->x() + 0.5));
    const int y = static_cast<int>(std::floor(pixel->y() + 0.5));
    if (views[v].silhouette(x, y) == PixelLabel::background) return false;
  }
  return seen;
}

// The farthest that anything can be: some times the distance between the cameras.
double farthest_depth(const std::vector<HullView>& views) {
  constexpr double kTimes = 5.0;
  double largest = 0.0;
  for (const HullView& a : views) {
    for (const HullView& b : views) {
      largest = std::max(largest, (a.camera.center_in_world() - b.camera.center_in_world()).norm());
    }
  }
  return kTimes * largest;
}

}  // namespace

std::vector<double> hull_coverage(const std::vector<HullView>& views) {
  constexpr double kNearest = 0.02;  // of the farthest depth
  const double farthest = farthest_depth(views);
  std::vector<double> shares;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const Camera& camera = views[v].camera;
    const Eigen::Vector3d center = camera.center_in_world();
    const std::vector<Eigen::Vector2d> pixels = sampled_pixels(views[v].silhouette);
    std::size_t covered = 0;
    for (const Eigen::Vector2d& pixel : pixels) {
      const Eigen::Vector3d ray = pixel_direction(camera, pixel);
      for (int i = 0; i < kDepths; ++i) {
        const double depth = farthest * std::pow(kNearest, 1.0 - (i + 0.5) / kDepths);
        if (!is_possible(views, v, center + depth * ray)) continue;
        ++covered;
        break;
      }
    }
    shares.push_back(
        pixels.empty() ? 0.0 : static_cast<double>(covered) / static_cast<double>(pixels.size()));
  }
  return shares;
}

}  // namespace tegata
