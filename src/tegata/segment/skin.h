// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"
#include "tegata/segment/segmentation_report.h"

namespace tegata {

struct SkinOptions {
  double blur_px = 0.8;          ///< standard deviation of the smoothing before anything else
  double smallest_share = 1.0;   ///< components with a smaller share of the largest are dropped
  double smallest_part = 0.002;  ///< of the picture; less skin than that is none
};

/// Skin by its colour: chrominance that any skin may have finds a first piece, whose own colours
/// and those of everything else in the same picture then tell skin from the rest; the border is
/// moved to where the colour is half way between the two sides nearby. The largest component, a
/// bare forearm included. Expects 3 channels; throws Error otherwise.
Silhouette segment_skin(const CameraImage& picture, const SkinOptions& options = {},
                        SegmentationReport* report = nullptr);

}  // namespace tegata
