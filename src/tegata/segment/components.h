// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tegata/image/silhouette.h"

namespace tegata {

/// Turns to background the connected pieces of hand (over corners as well) that have less than
/// `smallest_share` of the largest piece's pixels; 1 keeps the largest alone.
void keep_large_components(Silhouette& silhouette, double smallest_share);

/// Turns to background the pieces of hand with more than `most_px` pixels.
void drop_large_components(Silhouette& silhouette, std::size_t most_px);

/// Turns to background the pieces of hand without a pixel that is hand in `seeds`, too.
void keep_components_with(Silhouette& silhouette, const Silhouette& seeds);

/// Turns to hand the pieces of background (over sides alone) of at most `largest_px` pixels that do
/// not touch the edge of the picture.
void fill_pinholes(Silhouette& silhouette, int largest_px);

}  // namespace tegata
