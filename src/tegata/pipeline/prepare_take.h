// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/pipeline/frame_selection.h"
#include "tegata/pipeline/prepare_frame.h"
#include "tegata/take/take.h"

namespace tegata {

/// How a take's pictures become what the fit needs.
struct PrepareOptions {
  FrameSelection frames;
  std::optional<SegmentationMethod> segmentation;  ///< absent: what the take says, or chosen
  HullOptions hull;
  int threads = 0;
  /// Called in the order of the frames with each frame's simplified hull.
  std::function<void(const std::string& frame, const TriangleMesh& hull)> on_hull;
};

struct PreparedTake {
  std::vector<PreparedFrame> frames;
  std::vector<std::size_t> usable;  ///< which frames are without a refusal; never empty

  /// The usable frames; they point into `frames`.
  std::vector<const FitFrame*> fit_frames() const;
};

/// Where the take says that the hand is in its first frame; nothing, with a warning where it says
/// so in vain, if that is not the first one that is used.
std::optional<StartLandmarks> start_landmarks(const Take& take, bool from_first_frame,
                                              const Observer& observer);

/// Prepares the selected frames and gives the first one its landmarks, where the take has them.
/// Throws Error where no frame can be fitted.
PreparedTake prepare_take(Take& take, const PrepareOptions& options, const Observer& observer);

}  // namespace tegata
