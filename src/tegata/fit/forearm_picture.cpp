// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/forearm_picture.h"

#include <utility>
#include <vector>

#include "tegata/image/distance_transform.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

constexpr double kBesideHand = 0.012;  // of a hand of scale 1 [m]

bool ends_within(const Forearm& forearm, const Camera& camera) {
  const auto end = project(camera, forearm.end);
  return end && camera.contains(*end);
}

// How far each pixel lies outside the posed hand [px]; negative within it.
Image<float> outside_hand(const PosedHand& posed, const Camera& camera) {
  return signed_distance(render_silhouette(posed.surface(), camera),
                         [](PixelLabel label) { return label != PixelLabel::hand; });
}

}  // namespace

Silhouette forearm_picture(const FitHand& hand, const PosedHand& posed, const FitView& view,
                           const Forearm& forearm) {
  const Camera& camera = view.camera;
  Silhouette arm = render_silhouette(forearm.surface, camera);
  if (!ends_within(forearm, camera)) return arm;
  const double depth = (camera.camera_from_world * posed.keypoints()[kMiddleMcp]).z();
  const double beside_px = kBesideHand * hand.scale * camera.fx / depth;
  const Image<float> outside_px = outside_hand(posed, camera);
  const auto is_free = [&](int x, int y) {
    return arm.contains(x, y) && arm(x, y) != PixelLabel::hand && outside_px(x, y) > beside_px;
  };
  std::vector<std::pair<int, int>> reached;
  for (int y = 0; y < arm.height(); ++y) {
    for (int x = 0; x < arm.width(); ++x) {
      if (arm(x, y) == PixelLabel::hand) reached.emplace_back(x, y);
    }
  }
  while (!reached.empty()) {
    const auto [at_x, at_y] = reached.back();
    reached.pop_back();
    for (int y = at_y - 1; y <= at_y + 1; ++y) {
      for (int x = at_x - 1; x <= at_x + 1; ++x) {
        if (!is_free(x, y)) continue;
        // The first pixels beside what is seen as well: its contour runs between them.
        arm(x, y) = PixelLabel::hand;
        if (view.silhouette(x, y) == PixelLabel::hand) reached.emplace_back(x, y);
      }
    }
  }
  return arm;
}

}  // namespace tegata
