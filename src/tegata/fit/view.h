// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/contour.h"
#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// What the fit needs of one picture: an undistorted camera and what it saw. Copies share the
/// large pictures.
struct FitView {
  Camera camera;
  Silhouette silhouette;
  /// Signed distance [px] to the border of the hand's pixels, positive inside.
  std::shared_ptr<const Image<float>> hand_distance;
  /// The same for hand and unknown pixels together. Where the two agree, the nearest border is
  /// proven: it lies between hand and background.
  std::shared_ptr<const Image<float>> possible_distance;
  std::vector<ContourPoint> contour;  ///< proven border of the hand
  /// Depth of what hides the hand without being seen [m], infinite where nothing does; absent where
  /// nothing is known of it. What lies behind it may look like background.
  std::shared_ptr<const Image<float>> hiding_depth;

  /// Hand where the forearm is: it may hide the hand there or lie behind it, and looks alike.
  /// Absent where nothing is known of it.
  std::shared_ptr<const Silhouette> forearm;

  /// Whether the forearm is in this pixel.
  bool is_forearm(const Eigen::Vector2d& pixel) const;
  /// Whether something stands before a point of this depth [m] in this pixel.
  bool is_hidden(const Eigen::Vector2d& pixel, double depth) const;
};

/// Computes distances and contour. Throws Error where the camera is distorted or not of the
/// silhouette's size.
FitView make_fit_view(const Camera& camera, Silhouette silhouette);

}  // namespace tegata
