// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tegata/base/instruction_set.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/pair_sums.h"
#include "tegata/hand/skin_motion.h"
#include "tegata/hand/skin_rows.h"

namespace tegata {

/// A vertex of the hand and a plane that draws it. The residual is the vertex's distance from the
/// plane [m], its row add_vertex_row() along the normal.
struct SurfacePair {
  std::uint32_t vertex = 0;
  Eigen::Vector3d point, normal;  ///< of the plane, in world coordinates [m]
  double weight = 1.0;            ///< of the squared residual
};

/// Pairs made ready for normal equations at one pose after the other: sorted by the joint that
/// their vertices are next to, and then taken by vector. Single precision, about a point among the
/// pairs, which leaves some 10 nm of a hand's length; sums of more than a few hundred rows are in
/// double precision. Vertices that several digits or three bones move are taken one by one.
class SurfacePairs {
 public:
  SurfacePairs(const SkinRows& rows, std::span<const SurfacePair> pairs);

  /// Adds sum of w J^T J and of w J^T r at a pose to the equations of its frame, but no cost: a
  /// robust term has its own. Returns sum of w r^2 / 2. Every instruction set gives the same bits;
  /// it must be supported.
  double add_to(FrameEquations& equations, const SkinMotion& motion,
                InstructionSet set = best_instruction_set()) const;

 private:
  struct TangledPair {
    SurfacePair pair;
    std::array<double, 3> position = {};  ///< of the rest surface [m]
    std::array<double, kBoneCount> weights = {};
  };
  void add_tangled(const SkinRows& rows, const SurfacePair& pair);
  static double add_tangled_to(FrameEquations& equations, const SkinMotion& motion,
                               const TangledPair& tangled);
  std::span<const PairBlock> blocks(std::size_t bone) const;

  Eigen::Vector3d anchor_ = Eigen::Vector3d::Zero();
  std::unique_ptr<PairBlock[]> blocks_;
  std::array<std::size_t, kBoneCount + 1> first_ = {};  ///< blocks of each bone, then all
  std::vector<TangledPair> tangled_;
};

}  // namespace tegata
