// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "tegata/base/observer.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/pipeline/frame_selection.h"
#include "tegata/take/take.h"

namespace tegata {

struct HullTakeOptions {
  FrameSelection frames;
  std::optional<SegmentationMethod> segmentation;  ///< absent: what the take says, or chosen
  HullOptions hull;
  int threads = 0;
};

/// The visual hull of one frame.
struct TakeHull {
  std::string frame;
  std::string refusal;  ///< why there is none; empty where there is
  TriangleMesh mesh;
  HullReport report;
  double segment_seconds = 0.0;
  /// Of the hull's silhouette with the one that it was made from, by camera: intersection over
  /// union. Unknown pixels are left out.
  std::map<std::string, double> overlaps;
};

/// Pictures to silhouettes to hulls, without a hand. `on_hull` gets every frame in order. What is
/// wrong with one frame becomes its refusal.
void hull_take(Take& take, const HullTakeOptions& options,
               const std::function<void(const TakeHull& hull)>& on_hull, const Observer& observer);

}  // namespace tegata
