// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "hand_view.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace tegata {
namespace {

constexpr int kSamples = 3;  // a pixel's side, so that outlines are smooth
constexpr double kDistanceInRadii = 8.0;

}  // namespace

Ball ball_around(const TriangleMesh& surface) {
  Ball ball{bounding_box(surface).center(), 0.0};
  for (const Eigen::Vector3d& vertex : surface.vertices) {
    ball.radius = std::max(ball.radius, (vertex - ball.middle).norm());
  }
  return ball;
}

Camera camera_around(const Ball& ball, const View& view, int width, double radii, double share) {
  Camera camera;
  camera.name = "view";
  camera.width = camera.height = width;
  camera.fx = camera.fy = share * width * radii;
  camera.cx = camera.cy = 0.5 * (width - 1);
  const Eigen::Vector3d z = -view.from, y = -view.up;
  Eigen::Matrix3d rotation;
  rotation << y.cross(z).transpose(), y.transpose(), z.transpose();
  camera.camera_from_world.rotation = Eigen::Quaterniond(rotation);
  camera.camera_from_world.translation =
      -(rotation * (ball.middle + radii * ball.radius * view.from));
  return camera;
}

CameraImage draw_hand(const TriangleMesh& surface, const View& view, const Ball& ball, int width) {
  const int side = kSamples * width;
  CameraImage picture{Image<std::uint16_t>(side, side, kPaper[0], 3), 8};
  for (std::size_t i = 0; i < picture.values.values().size(); ++i) {
    picture.values.values()[i] = kPaper[i % 3];
  }
  draw_shaded(picture, surface, camera_around(ball, view, side, kDistanceInRadii, 0.47), kSkin);
  return shrunk(picture, width);
}

}  // namespace tegata
