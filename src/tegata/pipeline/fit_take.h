// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/hand/hand_model.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/pipeline/frame_selection.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

struct FitTakeOptions {
  FrameSelection frames;
  std::optional<SegmentationMethod> segmentation;  ///< absent: what the take says, or chosen
  HullOptions hull;
  GraspFitOptions fit;
  int threads = 0;
  /// Called in the order of the frames with each frame's simplified hull.
  std::function<void(const std::string& frame, const TriangleMesh& hull)> on_hull;
};

/// The whole way of the data: pictures, silhouettes, hulls, fit of each frame, fit of all frames.
/// The hand's side must be the take's. Frames that cannot be fitted keep an entry that says why.
/// Throws Error where nothing can be fitted at all.
Result fit_take(Take& take, const HandModel& hand, const FitTakeOptions& options,
                const Observer& observer);

}  // namespace tegata
