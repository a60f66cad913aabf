// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "tegata/camera/camera.h"
#include "tegata/image/overlay.h"

namespace tegata {

inline constexpr Colour kPaper = {250, 250, 248};
inline constexpr Colour kSkin = {214, 160, 126};

/// From where one looks, and what is up then: unit vectors, at right angles.
struct View {
  Eigen::Vector3d from, up;
};

/// What is to be seen whole.
struct Ball {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double radius = 0.0;  ///< [m]
};
Ball ball_around(const TriangleMesh& surface);

/// A camera of square pictures that looks at a ball from so many of its radii away. The radius
/// takes `share` of a picture's side.
Camera camera_around(const Ball& ball, const View& view, int width, double radii, double share);

/// A surface alone on paper, `width` pixels wide and high, with smooth edges, from so far away that
/// sizes are nearly as they are.
CameraImage draw_hand(const TriangleMesh& surface, const View& view, const Ball& ball, int width);

}  // namespace tegata
