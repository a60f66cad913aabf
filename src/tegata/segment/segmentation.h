// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// How a picture became a silhouette.
struct SegmentationReport {
  double threshold = 0.0;     ///< in the picture's own unit, where there is one
  std::size_t hand_pixels = 0;
};

struct InfraredOptions {
  double blur_px = 1.0;           ///< standard deviation of the smoothing before the threshold
  double smallest_share = 0.02;   ///< components with a smaller share of the largest are dropped
};
/// The warm hand in an infrared or thermal picture: flattened, thresholded (Otsu 1979 on its own
/// values), small components and pinholes removed. A picture without contrast gives an empty
/// silhouette.
Silhouette segment_infrared(const CameraImage& picture, const InfraredOptions& options = {},
                            SegmentationReport* report = nullptr);

struct SkinOptions {
  double smallest_share = 0.2;
};
/// Skin by its colour (chrominance, refined on the picture's own skin), largest component. Expects
/// 3 channels; throws Error otherwise.
Silhouette segment_skin(const CameraImage& picture, const SkinOptions& options = {},
                        SegmentationReport* report = nullptr);

struct BackgroundOptions {
  double smallest_share = 0.02;
};
/// What differs from the picture of the empty scene. Throws Error where size or channels differ.
Silhouette segment_background(const CameraImage& picture, const CameraImage& background,
                              const BackgroundOptions& options = {},
                              SegmentationReport* report = nullptr);

}  // namespace tegata
