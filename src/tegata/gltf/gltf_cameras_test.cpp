// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/gltf_cameras.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cmath>

#include "tegata/math/so3.h"

namespace tegata {
namespace {

// As a viewer draws it: through the node's transform and the perspective of the specification.
Eigen::Vector2d drawn_at(const tinygltf::Model& model, const tinygltf::Node& node,
                         const Eigen::Vector3d& point_in_world) {
  const tinygltf::PerspectiveCamera& view =
      model.cameras[static_cast<std::size_t>(node.camera)].perspective;
  const Eigen::Quaterniond turn(node.rotation.data());
  const Eigen::Vector3d point =
      turn.conjugate() *
      (point_in_world - Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
  const double scale = 1.0 / std::tan(0.5 * view.yfov);
  return {scale / view.aspectRatio * point.x() / -point.z(), scale * point.y() / -point.z()};
}

TEST(GltfCameras, ShowAPointWhereTheCameraDoes) {
  Camera camera;
  camera.name = "left";
  camera.width = 640;
  camera.height = 400;
  camera.fx = 900.0;
  camera.fy = 880.0;
  camera.cx = 319.5;  // the middle of the picture
  camera.cy = 199.5;
  camera.camera_from_world = {so3_exp({0.4, -0.8, 2.0}), {0.1, -0.2, 0.7}};
  tinygltf::Model model;
  const int index = add_gltf_camera(camera, model);
  const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
  EXPECT_EQ(node.name, "left");
  for (const Eigen::Vector3d& point_in_camera :
       {Eigen::Vector3d(0.0, 0.0, 0.5), Eigen::Vector3d(0.1, -0.05, 0.6)}) {
    const Eigen::Vector3d point = camera.camera_from_world.inverse() * point_in_camera;
    const Eigen::Vector2d pixel = project(camera, point).value();
    // From -1 to 1 over the picture, y up.
    const Eigen::Vector2d expected((pixel.x() + 0.5) / 320.0 - 1.0,
                                   1.0 - (pixel.y() + 0.5) / 200.0);
    EXPECT_LT((drawn_at(model, node, point) - expected).norm(), 1e-9);
  }
}

TEST(GltfCameras, NoteWhatPerspectiveDoesNotKnow) {
  Camera camera;
  camera.name = "left";
  camera.width = 640;
  camera.height = 400;
  camera.fx = camera.fy = 900.0;
  camera.cx = 300.0;
  camera.distortion[1] = 0.25;
  tinygltf::Model model;
  add_gltf_camera(camera, model);
  const tinygltf::Value& extras = model.cameras.front().extras;
  EXPECT_EQ(extras.Get("matrix").Get(2).GetNumberAsDouble(), 300.0);
  EXPECT_EQ(extras.Get("size").Get(1).GetNumberAsDouble(), 400.0);
  EXPECT_EQ(extras.Get("distortions").ArrayLen(), 12U);
  EXPECT_EQ(extras.Get("distortions").Get(1).GetNumberAsDouble(), 0.25);
}

}  // namespace
}  // namespace tegata
