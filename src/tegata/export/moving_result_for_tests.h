// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A movement for the tests of exports: any poses, two frames without one, awkward names.
#pragma once

#include <string>

#include "tegata/hand/test_hand.h"
#include "tegata/take/result.h"

namespace tegata {

inline HandModel moving_hand(Side side = Side::right) {
  return side == Side::right ? test_hand() : mirrored(test_hand());
}

inline Result moving_result(const HandModel& hand) {
  Result result;
  result.take = "a \"take\"";
  result.side = hand.skeleton.side;
  result.model_name = hand.name;
  result.grasp_angles = relaxed_angles();
  result.grasp_standard_deviations.setConstant(0.02);
  for (std::size_t i = 0; i < 8; ++i) {
    ResultFrame& frame = result.frames.emplace_back();
    frame.name = std::string(1, static_cast<char>('a' + i)) + "," + std::to_string(i);
    frame.time = 2.0 + 0.1 * static_cast<double>(i);
    frame.keypoints.fill(Eigen::Vector3d::Zero());
    frame.status = "seen by 1 camera, \"2\" or more are needed";
    if (i == 0 || i == 3) continue;
    frame.status = "ok";
    frame.pose = random_pose(i);
    // A finger bent by a quarter turn, where careless angles of BVH are none.
    if (i == 4) frame.pose->angles[5] = 1.5707963267948966;
    frame.keypoints = posed_keypoints(hand.skeleton, *frame.pose);
    for (std::size_t bone = 0; bone < frame.support.size(); ++bone) {
      frame.support[bone] = 0.05 * static_cast<double>(bone);
    }
    frame.views = {"left", "right"};
    frame.silhouette_iou = {{"left", 0.75}, {"right, above", 0.5}};
  }
  return result;
}

}  // namespace tegata
