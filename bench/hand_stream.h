// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/math/rigid3d.h"

namespace tegata::bench {

/// Silhouettes of a grasping hand that turns by 3 degrees a frame, with nothing before it, of
/// 640 x 480 pixels.
struct HandStream {
  HandStream(int camera_count, int frame_count);

  /// The mean over all keypoints of a frame [m].
  double keypoint_error(std::size_t frame, const HandPose& found) const;

  HandModel model;
  FitHand hand;
  JointAngles angles;
  std::vector<Rigid3d> poses;
  std::vector<std::vector<HullView>> frames;
};

/// A frame's distances and contours, with a hull of 2 mm or without.
FitFrame prepared(const std::vector<HullView>& views, bool with_hull, int threads);

}  // namespace tegata::bench
