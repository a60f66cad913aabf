// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "tegata/camera/camera.h"
#include "tegata/math/rigid3d.h"

namespace tegata {

/// A frame and a unit to compute in that do not depend on where a calibration has its origin, how
/// it is turned and what its unit is: the same cameras before the same hand have the same scene,
/// bit by bit, and whatever is computed from it the same answer.
struct SceneFrame {
  Rigid3d world_from_scene;      ///< of lengths in metres
  double metres_per_unit = 1.0;  ///< how many of the world's metres a metre of the scene is

  Camera in_scene(Camera camera) const;
  Eigen::Vector3d in_scene(const Eigen::Vector3d& point_in_world) const {
    return world_from_scene.inverse() * point_in_world / metres_per_unit;
  }
  Eigen::Vector3d in_world(const Eigen::Vector3d& point_in_scene) const {
    return world_from_scene * (metres_per_unit * point_in_scene);
  }
  /// world_from_b of scene_from_b.
  Rigid3d in_world(const Rigid3d& scene_from_b) const {
    return world_from_scene *
           Rigid3d{scene_from_b.rotation, metres_per_unit * scene_from_b.translation};
  }
};

/// The frame of the rig's first camera. Cameras in it are rounded to 0.06 um and as many millionths
/// of a radian, which no picture shows: a world elsewhere or of another size differs by the last
/// bits of its numbers, and they would decide which of two triangles is collapsed first, which of
/// two poses is a little better, and so at last a degree of some joint.
SceneFrame scene_frame(const CameraRig& rig, double metres_per_unit);

}  // namespace tegata
