// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tegata/image/silhouette.h"

namespace tegata {

/// A point on the border of a silhouette, between a hand pixel and a background pixel, to
/// sub-pixel position.
struct ContourPoint {
  Eigen::Vector2d pixel;
  Eigen::Vector2d normal;  ///< unit, from the hand to the background
};

/// All points of the border between hand and background; borders with unknown pixels and with the
/// edge of the picture say nothing about where the hand ends and are left out. Positions are half
/// way between the two pixels' centres along the row or column, smoothed over their neighbours so
/// that stairs do not show in the normals.
std::vector<ContourPoint> silhouette_contour(const Silhouette& silhouette);

}  // namespace tegata
