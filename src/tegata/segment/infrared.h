// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"
#include "tegata/segment/segmentation_report.h"

namespace tegata {

struct InfraredOptions {
  double blur_px = 0.8;          ///< standard deviation of the smoothing before the threshold
  double smallest_share = 0.02;  ///< components with a smaller share of the largest are dropped
};

/// The warm hand in an infrared or thermal picture (8 or 16 bit counts with any offset; of three
/// channels the mean): flattened, thresholded (Otsu 1979 on its own values), its border moved to
/// half of the contrast nearby, small components and pinholes removed. Where edges part the warm
/// into warmer pieces and the rest, as skin and sleeves, the warmer ones are the hand. A picture
/// without contrast, or whose bright part fades instead of ending, gives an empty silhouette. The
/// report's threshold is in counts above the background.
Silhouette segment_infrared(const CameraImage& picture, const InfraredOptions& options = {},
                            SegmentationReport* report = nullptr);

}  // namespace tegata
