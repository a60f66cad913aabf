// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
// For the tests of this room: a hand before three cameras on orthogonal axes.
#pragma once

#include <numbers>
#include <vector>

#include "tegata/base/text.h"
#include "tegata/camera/camera.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/solver.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hand/hand_model.h"
#include "tegata/image/rasterizer.h"
#include "tegata/math/so3.h"

namespace tegata::test {

inline const HandModel& coarse_hand() {
  static const HandModel hand = built_in_hand(HandShape{}, Side::right, {.triangle_count = 2000});
  return hand;
}

/// A half-closed hand; `turn` about the world's z axis [rad].
inline HandPose grasping_pose(double turn, double scale = 1.0) {
  HandPose pose;
  pose.world_from_hand = {so3_exp({0.0, 0.0, turn}) * so3_exp({0.4, 0.2, 0.1}),
                          scale * Eigen::Vector3d(0.01, -0.08, 0.02)};
  pose.angles = relaxed_angles();
  for (int digit = 1; digit < kDigitCount; ++digit) {
    pose.angles[4 * digit + 1] = 0.5;
    pose.angles[4 * digit + 2] = 0.6;
    pose.angles[4 * digit + 3] = 0.4;
  }
  return pose;
}

/// Ideal cameras along x, y and z that look at the origin from `distance` [m].
inline CameraRig orthogonal_rig(double distance) {
  CameraRig rig;
  const double quarter = 0.5 * std::numbers::pi;
  for (const Eigen::Vector3d& turn :
       {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0, quarter, 0.0),
        Eigen::Vector3d(quarter, 0.0, 0.0)}) {
    Camera camera;
    camera.name = text("camera_", rig.size());
    camera.width = 320;
    camera.height = 240;
    camera.fx = camera.fy = 600.0;
    camera.cx = 160.0;
    camera.cy = 120.0;
    camera.camera_from_world = {so3_exp(turn), Eigen::Vector3d(0.0, 0.0, distance)};
    rig.push_back(camera);
  }
  return rig;
}

/// What the cameras see of the hand, and its very surface as the hull.
inline FitFrame perfect_frame(const HandModel& hand, const HandPose& pose, const CameraRig& rig) {
  const TriangleMesh surface = PosedHand(hand, pose).surface();
  FitFrame frame;
  frame.hull.emplace(surface);
  for (const Camera& camera : rig) {
    frame.views.push_back(make_fit_view(camera, render_silhouette(surface, camera)));
  }
  return frame;
}

inline double mean_keypoint_distance(const HandModel& hand, const HandPose& a, const HandPose& b) {
  const auto of_a = posed_keypoints(hand.skeleton, a), of_b = posed_keypoints(hand.skeleton, b);
  double sum = 0.0;
  for (std::size_t k = 0; k < of_a.size(); ++k) sum += (of_a[k] - of_b[k]).norm();
  return sum / static_cast<double>(of_a.size());
}

}  // namespace tegata::test
