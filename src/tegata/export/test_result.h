// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A result for the room's own tests: two cameras, the last frame without a pose.
#pragma once

#include "tegata/base/text.h"
#include "tegata/take/result.h"

namespace tegata {

inline Result test_result(std::size_t frame_count) {
  Result result;
  result.take = "cup & <saucer>";
  result.model_name = "test \"hand\"";
  result.grasp_angles = relaxed_angles();
  result.grasp_standard_deviations.setConstant(0.02);
  result.iterations = 12;
  result.termination = "converged";
  result.seconds = {{"frames", 1.5}, {"hull", 0.25}};
  for (std::size_t i = 0; i < frame_count; ++i) {
    ResultFrame frame;
    frame.name = text("frame", i);
    frame.time = 2.0 + 0.1 * static_cast<double>(i);
    if (i + 1 < frame_count || frame_count == 1) {
      HandPose pose;
      pose.world_from_hand.translation.z() = 0.5;
      pose.angles = relaxed_angles() + JointAngles::Constant(0.01 * static_cast<double>(i));
      frame.pose = pose;
      frame.keypoints.fill(Eigen::Vector3d(0.0, 0.0, 0.5));
      frame.support.fill(0.25);
      frame.views = {"left", "right"};
      frame.silhouette_iou = {{"left", 0.75}, {"right", 0.5}};
    } else {
      frame.keypoints.fill(Eigen::Vector3d::Zero());
      frame.status = "seen by 1 camera < 2";
    }
    result.frames.push_back(frame);
  }
  return result;
}

}  // namespace tegata
