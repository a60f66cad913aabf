// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tegata/base/instruction_set.h"
#include "tegata/hull/octree_division.h"
#include "tegata/image/image.h"

namespace tegata {

/// What the field of silhouettes needs of one view, on the lattice of an octree.
struct SampledView {
  /// Homogeneous pixel (x times depth, y times depth, depth [m]) of the lattice's first point, and
  /// what one cell along each axis adds to it.
  std::array<float, 3> origin;
  std::array<std::array<float, 3>, 3> steps;
  float width = 0.0f, height = 0.0f;  ///< of the picture [px]
  float metres_per_pixel = 0.0f;      ///< at a depth of 1 m
  float least_depth = 0.0f;           ///< nothing nearer is seen [m]
  /// Signed distance to the silhouette's edge as packed_pairs() gives it, and 1 where a pixel is
  /// unknown (empty where none is), in the part of the picture that begins at pixel (left, top); at
  /// least 2 x 2. Beyond it the distance goes on as a straight line and nothing is unknown.
  Image<std::uint32_t> distance;
  float distance_step = 0.0f;  ///< [px] of one step of `distance`
  Image<float> unknown;
  float left = 0.0f, top = 0.0f;
};

inline constexpr std::size_t kMostViews = 32;  ///< as many as a set of views has bits
inline constexpr std::size_t kMostDissentingViews = 15;

/// Views as bits.
using ViewSet = std::uint32_t;

/// How the views' words are weighed; see HullOptions.
struct SamplingRule {
  std::size_t least_views = 2;       ///< so many views suffice to see a point,
  std::size_t least_across = 2;      ///< or so many of which two look across each other:
  std::vector<ViewSet> across;       ///< by view, those across it; empty: none
  std::size_t dissenting_views = 0;  ///< at most kMostDissentingViews
  float outside_value = -1.0f;       ///< where views do not suffice [m]
  /// Fields are no larger than this [m]. So near the surface none is, and a view that is sure to
  /// say more need not be asked.
  float largest_value = std::numeric_limits<float>::infinity();

  /// Whether a point that these views see is seen well enough.
  bool suffices(ViewSet views) const;
};

using SilhouetteBlock = BlockValues<4>;

/// What is known of a block, so that views are asked no more than they need be.
struct BlockKnowledge {
  ViewSet certain = 0;  ///< see all its points as hand, farther inside than largest_value
  ViewSet whole = 0;    ///< see all its points, as whatever
};

/// Each pixel's value and its right neighbour's in 16 bits each (low and high), in steps of
/// packing_step(largest), so that one look-up fetches both. Values are within -largest .. largest.
Image<std::uint32_t> packed_pairs(const Image<float>& values, float largest);
float packing_step(float largest);

/// The field at the points of a block: the (dissenting_views + 1)th smallest of how far inside
/// their silhouettes' edges the views that see the point say that it is [m]. Unproven are points
/// that only unknown pixels keep inside, and those that are outside because too few views see them.
/// Of a block without any point inside nothing but that is right: no leaf comes of it.
/// Every instruction set gives the same bits; it must be supported.
void sample_block(const std::vector<SampledView>& views, const SamplingRule& rule,
                  const BlockKnowledge& known, const LatticeIndex& low, InstructionSet set,
                  SilhouetteBlock& block);

}  // namespace tegata
