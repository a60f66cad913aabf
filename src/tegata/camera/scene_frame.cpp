// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/camera/scene_frame.h"

#include <cmath>

namespace tegata {
namespace {

double rounded(double number) {
  constexpr int kBits = 24;
  return std::ldexp(std::round(std::ldexp(number, kBits)), -kBits);
}

}  // namespace

Camera SceneFrame::in_scene(Camera camera) const {
  const Rigid3d from_scene = camera.camera_from_world * world_from_scene;
  Eigen::Vector4d turn = from_scene.rotation.coeffs();
  if (turn.w() < 0.0) turn = -turn;  // the same turn; one sign for both
  camera.camera_from_world.rotation =
      Eigen::Quaterniond(Eigen::Vector4d(turn.unaryExpr(&rounded))).normalized();
  camera.camera_from_world.translation =
      (from_scene.translation / metres_per_unit).unaryExpr(&rounded);
  return camera;
}

SceneFrame scene_frame(const CameraRig& rig, double metres_per_unit) {
  return {rig.front().camera_from_world.inverse(), metres_per_unit};
}

}  // namespace tegata
