// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "tegata/image/image.h"

namespace tegata {

/// What a pixel shows; the values are those of the mask files.
enum class PixelLabel : std::uint8_t {
  background = 0,
  unknown = 128,  ///< something in front may hide the hand: carves nothing, proves nothing
  hand = 255,
};

/// One label a pixel.
using Silhouette = Image<PixelLabel>;

/// How many pixels carry a label.
std::size_t count_pixels(const Silhouette& silhouette, PixelLabel label);

/// Pixels that are hand in both over pixels that are hand in either; pixels that are unknown in one
/// of the two are left out. 0 where neither has a hand pixel.
double intersection_over_union(const Silhouette& a, const Silhouette& b);

}  // namespace tegata
