// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"
#include "tegata/segment/segmentation_report.h"

namespace tegata {

struct BackgroundOptions {
  double blur_px = 0.8;           ///< standard deviation of the smoothing of the difference
  double smallest_share = 0.02;   ///< components with a smaller share of the largest are dropped
  double smallest_part = 0.0005;  ///< of the picture; less difference than that is none
};

/// What differs from the picture of the empty scene by more than the noise, which is measured on
/// the difference itself; its border is moved to half of the difference nearby. Nothing where
/// nothing differs. The report's threshold is a difference of values. Throws Error where size,
/// channels or bits differ.
Silhouette segment_background(const CameraImage& picture, const CameraImage& background,
                              const BackgroundOptions& options = {},
                              SegmentationReport* report = nullptr);

}  // namespace tegata
