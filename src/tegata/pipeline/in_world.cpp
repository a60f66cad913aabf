// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/in_world.h"

namespace tegata {

TriangleMesh in_world(const SceneFrame& scene, TriangleMesh mesh) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = scene.in_world(vertex);
  for (Eigen::Vector3d& normal : mesh.normals) normal = scene.world_from_scene.rotation * normal;
  return mesh;
}

Result in_world(const SceneFrame& scene, Result result) {
  for (ResultFrame& frame : result.frames) {
    if (!frame.pose) continue;
    frame.pose->world_from_hand = scene.in_world(frame.pose->world_from_hand);
    for (Eigen::Vector3d& keypoint : frame.keypoints) keypoint = scene.in_world(keypoint);
    for (auto& [camera, distance] : frame.uncovered) distance *= scene.metres_per_unit;
  }
  for (Eigen::Vector3d& vertex : result.object.vertices) vertex *= scene.metres_per_unit;
  return result;
}

}  // namespace tegata
