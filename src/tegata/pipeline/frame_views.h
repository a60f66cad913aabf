// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tegata/hull/visual_hull.h"
#include "tegata/pipeline/silhouettes.h"
#include "tegata/take/take.h"

namespace tegata {

/// The undistorted silhouettes of one frame.
struct FrameViews {
  std::string name;
  double time = 0.0;               ///< [s]
  std::string refusal;             ///< why nothing can be made of it; empty where it can
  std::vector<std::string> notes;  ///< what a user should know of it
  std::vector<HullView> views;     ///< in which the hand was seen
  std::map<std::string, std::string> left_out;  ///< why, by camera of the other pictures
  double seconds = 0.0;                         ///< of segmentation and undistortion
};

/// Segments and undistorts a frame's pictures. A view without any hand pixel is left out: one
/// camera that looks elsewhere must not empty the hull. Fewer than two views are a refusal.
FrameViews frame_views(const Segmenter& segmenter, const TakeFrame& pictures);

}  // namespace tegata
