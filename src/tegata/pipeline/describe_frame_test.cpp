// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/describe_frame.h"

#include <gtest/gtest.h>

#include "tegata/hand/built_in_hand.h"
#include "tegata/image/rasterizer.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

Camera camera_at(double turn, const char* name) {
  Camera camera;
  camera.name = name;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 500.0;
  camera.cx = 160.0;
  camera.cy = 120.0;
  camera.camera_from_world = {so3_exp({0.0, turn, 0.0}), Eigen::Vector3d(0.0, 0.0, 0.9)};
  return camera;
}

// An overlap of all in one picture makes up for nothing in the other where only the mean is asked.
TEST(DescribeFrame, AHandThatOneCameraAloneSeesIsNotCalledOk) {
  const HandModel hand = built_in_hand(HandShape{}, Side::right, {.triangle_count = 600});
  HandPose pose;
  pose.world_from_hand.translation = {0.0, -0.08, 0.0};
  const TriangleMesh surface = PosedHand(hand, pose).surface();
  PreparedFrame prepared;
  for (const Camera& camera : {camera_at(0.0, "front"), camera_at(1.5, "side")}) {
    prepared.frame.views.push_back(make_fit_view(camera, render_silhouette(surface, camera)));
  }
  const FitHand fit_hand(hand);
  EXPECT_EQ(describe_frame(fit_hand, pose, prepared).status, "ok");

  Camera elsewhere = camera_at(1.5, "side");
  elsewhere.camera_from_world.translation.y() = 0.2;
  FitView& side = prepared.frame.views[1];
  side = make_fit_view(side.camera, render_silhouette(surface, elsewhere));
  const ResultFrame doubtful = describe_frame(fit_hand, pose, prepared);
  EXPECT_GT(doubtful.silhouette_iou.at("front"), 0.9);
  EXPECT_EQ(doubtful.status, "no second camera sees a hand where it is fitted");
}

}  // namespace
}  // namespace tegata
