// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/camera/scene_frame.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tegata/math/so3.h"

namespace tegata {
namespace {

CameraRig three_cameras() {
  CameraRig rig;
  for (int i = 0; i < 3; ++i) {
    Camera camera;
    camera.name = std::string(1, static_cast<char>('a' + i));
    camera.width = 640;
    camera.height = 480;
    camera.fx = camera.fy = 700.0;
    camera.cx = 319.5;
    camera.cy = 239.5;
    camera.camera_from_world = {so3_exp({0.3 * i, 1.1 * i - 0.4, 0.2}),
                                Eigen::Vector3d(0.013 * i, -0.02, 0.77)};
    rig.push_back(camera);
  }
  return rig;
}

// The same cameras in a world that is turned, then enlarged, then moved.
CameraRig in_another_world(CameraRig rig, const Rigid3d& other_from_world, double enlarged) {
  for (Camera& camera : rig) {
    camera.camera_from_world.translation *= enlarged;
    camera.camera_from_world = camera.camera_from_world * other_from_world.inverse();
  }
  return rig;
}

TEST(SceneFrame, CamerasOfAMovedTurnedAndEnlargedWorldAreTheSameBitByBit) {
  const CameraRig rig = three_cameras();
  const Rigid3d elsewhere = {so3_exp({1.0, -2.0, 0.7}), Eigen::Vector3d(100.0, -60.0, 35.0)};
  const CameraRig other = in_another_world(rig, elsewhere, 10.0);
  const SceneFrame scene = scene_frame(rig, 1.0), other_scene = scene_frame(other, 10.0);
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const Rigid3d a = scene.in_scene(rig[i]).camera_from_world;
    const Rigid3d b = other_scene.in_scene(other[i]).camera_from_world;
    EXPECT_EQ(a.rotation.coeffs(), b.rotation.coeffs()) << i;
    EXPECT_EQ(a.translation, b.translation) << i;
  }
}

TEST(SceneFrame, APointIsSeenWhereItWas) {
  const CameraRig rig = three_cameras();
  const SceneFrame scene = scene_frame(rig, 10.0);
  const Eigen::Vector3d point(0.03, -0.05, 0.02);
  for (const Camera& camera : rig) {
    const auto before = project(camera, point);
    const auto after = project(scene.in_scene(camera), scene.in_scene(point));
    ASSERT_TRUE(before && after);
    EXPECT_LT((*before - *after).norm(), 1e-3);
  }
}

TEST(SceneFrame, WhatIsFoundComesBackToTheWorld) {
  const SceneFrame scene = scene_frame(three_cameras(), 0.1);
  const Eigen::Vector3d point(0.03, -0.05, 0.02);
  EXPECT_LT((scene.in_world(scene.in_scene(point)) - point).norm(), 1e-15);
  const Rigid3d scene_from_hand = {so3_exp({0.2, 0.1, -0.4}), Eigen::Vector3d(0.1, 0.2, 0.9)};
  const Eigen::Vector3d in_hand(0.01, 0.02, 0.03);  // of the scene's metres
  const Eigen::Vector3d by_point = scene.in_world(scene_from_hand * in_hand);
  const Eigen::Vector3d by_pose =
      scene.in_world(scene_from_hand) * (scene.metres_per_unit * in_hand);
  EXPECT_LT((by_point - by_pose).norm(), 1e-15);
}

}  // namespace
}  // namespace tegata
