// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// A silhouette as tangent planes see it: the corners of the convex hull of its hand pixels.
struct OutlineRays {
  std::vector<Eigen::Vector3d> rays;  ///< unit, in the camera's frame
  std::vector<bool> cut;  ///< by the picture's edge or next to unknown pixels: proves no tangent
};

/// Nothing where the silhouette has fewer than 30 hand pixels. Pixels that fewer than two of their
/// four neighbours share count as noise. A camera with distortion, in whose picture straight lines
/// bow, may lose some corners.
std::optional<OutlineRays> outline_rays(const Silhouette& silhouette, const Camera& camera);

/// One camera per column, as the rig has them, in some frames; nothing where it saw no hand.
using RigOutlines = std::vector<std::vector<std::optional<OutlineRays>>>;

/// The convex hull of points in the plane, counter-clockwise (Andrew 1979); collinear points are
/// left out.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

}  // namespace tegata
