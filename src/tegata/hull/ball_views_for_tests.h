// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tegata/hull/visual_hull.h"

namespace tegata::scenes {

/// A camera of 320 x 240 pixels at `from` that looks at `target`.
inline Camera camera_at(const std::string& name, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& target, double focal_length_px) {
  Camera camera;
  camera.name = name;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = focal_length_px;
  camera.cx = 159.5;
  camera.cy = 119.5;
  const Eigen::Vector3d forward = (target - from).normalized();
  const Eigen::Vector3d down =
      std::abs(forward.y()) > 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  Eigen::Matrix3d camera_from_world;
  camera_from_world.row(0) = down.cross(forward).normalized();
  camera_from_world.row(2) = forward;
  camera_from_world.row(1) = forward.cross(camera_from_world.row(0).transpose());
  camera.camera_from_world.rotation = Eigen::Quaterniond(camera_from_world);
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * from);
  return camera;
}

/// What an undistorted camera sees of a ball: hand where the ray through a pixel's centre meets it.
inline Silhouette ball_silhouette(const Camera& camera, const Eigen::Vector3d& center,
                                  double radius) {
  const Eigen::Vector3d middle = camera.camera_from_world * center;
  Silhouette silhouette(camera.width, camera.height, PixelLabel::background);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d direction =
          Eigen::Vector3d((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1.0)
              .normalized();
      if (direction.cross(middle).norm() < radius) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

/// Views from `count` sides, `distance` away, in which the ball's picture has a radius of about
/// `radius_px`. The first three look along the axes; the others are spread on a spiral.
inline std::vector<HullView> views_of_ball(int count, const Eigen::Vector3d& center, double radius,
                                           double distance, double radius_px) {
  std::vector<HullView> views;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d side = Eigen::Vector3d::Unit(i % 3);
    if (i >= 3) {
      const double z = -0.8 + 1.6 * (i - 2.5) / (count - 3), around = 2.4 * i;
      side = {std::sqrt(1.0 - z * z) * std::cos(around), std::sqrt(1.0 - z * z) * std::sin(around),
              z};
    }
    const Camera camera = camera_at("view_" + std::to_string(i), center + distance * side, center,
                                    radius_px * distance / radius);
    views.push_back({camera, ball_silhouette(camera, center, radius)});
  }
  return views;
}

}  // namespace tegata::scenes
