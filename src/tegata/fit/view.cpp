// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/view.h"

#include <cmath>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/image/distance_transform.h"
#include "tegata/image/pixel_box.h"

namespace tegata {

bool FitView::is_hidden(const Eigen::Vector2d& pixel, double depth) const {
  if (!hiding_depth) return false;
  const int x = static_cast<int>(std::lround(pixel.x()));
  const int y = static_cast<int>(std::lround(pixel.y()));
  return hiding_depth->contains(x, y) && (*hiding_depth)(x, y) < depth;
}

bool FitView::is_forearm(const Eigen::Vector2d& pixel) const {
  if (!forearm) return false;
  const int x = static_cast<int>(std::lround(pixel.x()));
  const int y = static_cast<int>(std::lround(pixel.y()));
  return forearm->contains(x, y) && (*forearm)(x, y) == PixelLabel::hand;
}

FitView make_fit_view(const Camera& camera, Silhouette silhouette) {
  if (camera.is_distorted() || silhouette.width() != camera.width ||
      silhouette.height() != camera.height) {
    throw Error("camera '", camera.name, "': got a silhouette of ", silhouette.width(), " x ",
                silhouette.height(), (camera.is_distorted() ? " and a distorted camera" : ""),
                ", expected an undistorted camera and a size of ", camera.width, " x ",
                camera.height);
  }
  FitView view;
  view.camera = camera;
  view.hand_distance = std::make_shared<const Image<float>>(
      signed_distance(silhouette, [](PixelLabel label) { return label == PixelLabel::hand; }));
  if (bounds_of(silhouette, PixelLabel::unknown).empty()) {
    view.possible_distance = view.hand_distance;
  } else {
    view.possible_distance = std::make_shared<const Image<float>>(signed_distance(
        silhouette, [](PixelLabel label) { return label != PixelLabel::background; }));
  }
  view.contour = silhouette_contour(silhouette);
  view.silhouette = std::move(silhouette);
  return view;
}

}  // namespace tegata
