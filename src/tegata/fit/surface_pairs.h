// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tegata/base/instruction_set.h"
#include "tegata/fit/normal_equations.h"
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

/// Pairs made ready for normal equations at one pose after the other: sorted by the digit that
/// moves their vertices, of which each needs four columns of the twenty, and then taken by vector.
/// Single precision, about a point among the pairs, which leaves some 10 nm of a hand's length;
/// sums of more than a few hundred rows are in double precision.
class SurfacePairs {
 public:
  SurfacePairs(const SkinRows& rows, std::span<const SurfacePair> pairs);

  /// Adds sum of w J^T J and of w J^T r at a pose to the equations of its frame, but no cost: a
  /// robust term has its own. Returns sum of w r^2 / 2. Every instruction set gives the same bits;
  /// it must be supported.
  double add_to(FrameEquations& equations, const SkinMotion& motion,
                InstructionSet set = best_instruction_set()) const;

  using Lanes = std::array<float, kRowLanes>;
  struct alignas(64) Block {
    std::array<Lanes, 3> position;  ///< of the rest surface [m]
    std::array<Lanes, 4> weights;   ///< of the palm and the digit's bones
    std::array<Lanes, 3> normal;    ///< of the plane
    Lanes offset;                   ///< of the plane from anchor_ [m]
    Lanes weight;                   ///< of the residual; 0 in lanes that hold none
  };

 private:
  /// A row of a vertex that several digits move; those of one pair follow each other.
  struct SharedRow {
    std::size_t part = 0;
    std::array<double, 3> position = {};
    std::array<double, 4> weights = {};
  };
  struct SharedPair {
    SurfacePair pair;
    std::vector<SharedRow> rows;
  };
  void add_shared(const SkinRows& rows, const SkinRows::SharedVertex& shared,
                  const SurfacePair& pair);
  static double add_shared_to(FrameEquations& equations, const SkinMotion& motion,
                              const SharedPair& shared);

  Eigen::Vector3d anchor_ = Eigen::Vector3d::Zero();
  std::vector<Block> blocks_;
  std::array<SkinRows::Part, kDigitCount + 1> parts_;  ///< the digits' and the palm's
  std::vector<SharedPair> shared_;
};

}  // namespace tegata
