// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tegata/base/instruction_set.h"
#include "tegata/hand/skin_rows.h"

namespace tegata {

/// Pairs of a vertex next to one joint and a plane, made for vectors. Single precision, about the
/// joint's centre, so that no product is far larger than what is left of it in the end.
struct alignas(64) PairBlock {
  using Lanes = std::array<float, kRowLanes>;
  std::array<Lanes, 3> beyond, before;  ///< as SkinRows::HingedVertex has them
  std::array<Lanes, 3> normal;  ///< of the plane, times the weight's root; 0 in lanes without one
  Lanes offset;                 ///< of the plane from an anchor [m], times the weight's root
};

/// What moves such pairs.
struct JointMotion {
  struct Vec {
    float x, y, z;
  };
  using Turn = std::array<Vec, 3>;  ///< rows, from the rest surface to world axes
  Turn beyond, before;              ///< of the bones on either side of the joint
  std::array<Vec, 2> axes;          ///< directions of the joint's angles
  Vec from_anchor;                  ///< to the joint's centre
};

/// The products of two of a pair's numbers, summed over pairs, row by row of the lower half: moment
/// of the normal (3), normal (3), residual, derivatives by the joint's own angles (none, one or
/// two). Moment and normal are the derivatives by a turn about the joint's centre and by a shift,
/// from which those by all angles before this joint follow.
template <std::size_t kAngles>
inline constexpr std::size_t kPairProducts = (7 + kAngles) * (8 + kAngles) / 2;
template <std::size_t kAngles>  // and then up to a whole vector the last one again
using PairSums = std::array<double, (kPairProducts<kAngles> + 15) / 16 * 16>;

/// Every instruction set gives the same bits; it must be supported. Sums of more than a few hundred
/// pairs are in double precision.
template <std::size_t kAngles>
void sum_up(std::span<const PairBlock> blocks, const JointMotion& motion, InstructionSet set,
            PairSums<kAngles>& sums);

}  // namespace tegata
