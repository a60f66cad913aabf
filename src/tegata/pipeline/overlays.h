// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/hand/hand_model.h"
#include "tegata/image/image.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

/// A camera's picture with the outlines of the silhouette and of the fitted hand over it.
struct Overlay {
  std::string frame, camera;
  CameraImage picture;  ///< 8 bit, 3 channels
};

struct OverlayOptions {
  std::size_t most_frames = 8;  ///< those with a pose, spread evenly
  int widest = 480;             ///< of a picture [px]
  /// What the result was made with, where that was asked for.
  std::optional<SegmentationMethod> segmentation = std::nullopt;
};

/// The overlays of the frames of a result. Throws Error where the take lacks one of them.
std::vector<Overlay> draw_overlays(Take& take, const Result& result, const HandModel& hand,
                                   const OverlayOptions& options, const Observer& observer);

}  // namespace tegata
