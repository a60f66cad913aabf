// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/forearm_picture.h"

#include <cmath>

#include "tegata/image/distance_transform.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

constexpr double kBesideHand = 0.012;  // of a hand of scale 1 [m]

// How far each pixel lies outside the posed hand and what the hull has before the wrist [px];
// negative within.
Image<float> outside_hand(const FitHand& fit_hand, const PosedHand& posed, const HullTarget& hull,
                          const Camera& camera) {
  Silhouette hand = render_silhouette(posed.vertices(), fit_hand.drawn, camera);
  const Rigid3d hand_from_world = posed.pose().world_from_hand.inverse();
  for (const Eigen::Vector3d& point : hull.nearest.points()) {
    if ((hand_from_world * point).y() < 0.0) continue;
    const auto pixel = project(camera, point);
    if (!pixel) continue;
    const int x = static_cast<int>(std::lround(pixel->x()));
    const int y = static_cast<int>(std::lround(pixel->y()));
    if (hand.contains(x, y)) hand(x, y) = PixelLabel::hand;
  }
  return signed_distance(hand, [](PixelLabel label) { return label != PixelLabel::hand; });
}

}  // namespace

Silhouette forearm_picture(const FitHand& hand, const PosedHand& posed, const FitFrame& frame,
                           const Camera& camera, const Forearm& forearm) {
  Silhouette arm = render_silhouette(forearm.surface, camera);
  const Silhouette beyond = render_silhouette(forearm.beyond, camera);
  if (!frame.hull || count_pixels(beyond, PixelLabel::hand) == 0) return arm;
  const double depth = (camera.camera_from_world * posed.keypoints()[kMiddleMcp]).z();
  const double beside_px = kBesideHand * hand.scale * camera.fx / depth;
  const Image<float> outside_px = outside_hand(hand, posed, *frame.hull, camera);
  for (std::size_t i = 0; i < arm.values().size(); ++i) {
    if (beyond.values()[i] == PixelLabel::hand && outside_px.values()[i] > beside_px) {
      arm.values()[i] = PixelLabel::hand;
    }
  }
  return arm;
}

}  // namespace tegata
