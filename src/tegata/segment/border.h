// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// How a side's values may change with the depth behind the border: not at all, evenly, or with its
/// root, as on a round body that is lit from beside the camera (there the cosine of its slant
/// does).
enum class Shading { none, even, round };

/// Where around a rough border the two sides' own levels are taken from.
struct BorderOptions {
  Shading shading = Shading::even;
  int clearance_px = 3;  ///< pixels nearer to the border are neither side's for sure
  int reach_px = 12;     ///< of the square window over which a side's level is averaged
};

/// What the two sides of a border are like at the border itself, averaged over its pixels; 0 where
/// no border has both sides in reach.
struct BorderReport {
  double contrast = 0.0;     ///< how much brighter the hand is (first channel)
  double clear_share = 0.0;  ///< of the border, on which the two differ by more than their spread
};

/// Moves the border between hand and background to where a picture (1 or 3 channels, with noise of
/// the given standard deviation) is half way between the levels of the two sides nearby. That is
/// where the border is under a symmetric blur and a vignetting, which a single threshold is not. A
/// side's level is the one that its pixels nearby lead to at the border, by the shading. Of several
/// channels it takes the combination that tells the two sides apart best there (Fisher 1936). A
/// pixel near the border keeps its label where one of the sides has no sure pixel in reach, or
/// where the levels differ by less than three times their spread.
BorderReport move_border_to_half_height(const Image<float>& picture, double noise,
                                        const BorderOptions& options, Silhouette& silhouette);

}  // namespace tegata
