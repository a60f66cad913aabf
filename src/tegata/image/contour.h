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
/// edge of the picture say nothing about where the hand ends and are left out, as are points within
/// 2 pixels of them. There is one point for each pair of neighbours of the two labels, at most 0.75
/// pixels from the middle between their centres, where the blurred hand ends, so that stairs do
/// not show. On a disk of 8 to 50 pixels radius positions are off by 0.14 px rms (mean 0.02) and
/// normals by 2.3 degrees.
std::vector<ContourPoint> silhouette_contour(const Silhouette& silhouette);

}  // namespace tegata
