// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// The signed distance [px] of each pixel's centre to the edge of the set of pixels that `inside`
/// says: positive inside. That is the distance to the nearest pixel centre of the other kind less
/// half a pixel, as the edge lies half way between pixels. Exact (Felzenszwalb and
/// Huttenlocher 2012). Where no pixel is inside (or none outside), all are -(or +) width + height.
Image<float> signed_distance(const Silhouette& silhouette,
                             const std::function<bool(PixelLabel)>& inside);

/// The value between pixel centres, bilinear; positions outside take the nearest pixel's.
float sample_bilinear(const Image<float>& image, double x, double y);

}  // namespace tegata
