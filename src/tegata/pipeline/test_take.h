// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
// For the tests of this room: a take on disk of a hand before three cameras, made of masks or of
// warm pictures.
#pragma once

#include <filesystem>
#include <numbers>

#include "tegata/base/text.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/image/rasterizer.h"
#include "tegata/math/so3.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"

namespace tegata::test {

inline const HandModel& small_hand() {
  static const HandModel hand = built_in_hand(HandShape{}, Side::right, {.triangle_count = 1500});
  return hand;
}

inline CameraRig small_rig() {
  CameraRig rig;
  const double quarter = 0.5 * std::numbers::pi;
  for (const Eigen::Vector3d& turn :
       {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0, quarter, 0.0),
        Eigen::Vector3d(quarter, 0.0, 0.0)}) {
    Camera camera;
    camera.name = text("camera_", rig.size());
    camera.width = 200;
    camera.height = 160;
    camera.fx = camera.fy = 450.0;
    camera.cx = 100.0;
    camera.cy = 80.0;
    camera.distortion = {-0.05};
    camera.camera_from_world = {so3_exp(turn), Eigen::Vector3d(0.0, 0.0, 0.8)};
    rig.push_back(camera);
  }
  return rig;
}

inline HandPose small_pose(std::size_t frame) {
  HandPose pose;
  pose.world_from_hand = {so3_exp({0.4, 0.2, 0.1 + 0.2 * static_cast<double>(frame)}),
                          Eigen::Vector3d(0.0, -0.08, 0.0)};
  pose.angles = relaxed_angles();
  return pose;
}

inline Silhouette small_silhouette(std::size_t frame, std::size_t camera) {
  return render_silhouette(PosedHand(small_hand(), small_pose(frame)).surface(),
                           small_rig()[camera]);
}

/// Writes calibration and masks of `frame_count` frames. The last camera lacks the last frame.
inline void write_mask_take(const std::filesystem::path& folder, std::size_t frame_count) {
  const CameraRig rig = small_rig();
  write_calibration(rig, folder / "calibration.toml");
  for (std::size_t c = 0; c < rig.size(); ++c) {
    const std::filesystem::path masks = folder / "masks" / rig[c].name;
    std::filesystem::create_directories(masks);
    for (std::size_t f = 0; f < frame_count; ++f) {
      if (c + 1 == rig.size() && f + 1 == frame_count) continue;
      write_picture(mask_from_silhouette(small_silhouette(f, c)), masks / text("00000", f, ".png"));
    }
  }
}

}  // namespace tegata::test
