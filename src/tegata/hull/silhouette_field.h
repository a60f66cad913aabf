// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "tegata/hull/block_sampling.h"
#include "tegata/hull/silhouette_table.h"
#include "tegata/hull/visual_hull.h"

namespace tegata {

/// What the silhouettes say of a point or a cube: the source that the hull's octree divides by.
/// Refers to the views' silhouettes, which must outlive it.
class SilhouetteField {
 public:
  /// Throws Error, naming the view, on lens distortion, sizes that do not match, silhouettes that
  /// show nothing, and on options that the number of views does not allow.
  SilhouetteField(const std::vector<HullView>& views, const HullOptions& options);

  /// What a cube's eighths need not ask again.
  struct State {
    ViewSet inside = 0;   ///< see all of the cube, and all of it before the hand
    ViewSet outside = 0;  ///< see all of the cube, and all of it before the background
    ViewSet blind = 0;    ///< see nothing of it
    ViewSet whole = 0;    ///< see all of it
  };
  Occupancy classify(const Eigen::Vector3d& center, double half_side, State& state) const;

  /// Prepares sample() for the lattice of an octree; classify() needs it not, but is then as
  /// careful as sample()'s rounding asks for.
  void prepare_sampling(const OctreeRoot& root);
  /// How far inside the silhouettes the lattice points of a block are [m].
  static constexpr int kBlockCells = 4;
  void sample(const LatticeIndex& low, const State& state, SilhouetteBlock& block) const;

  /// Whether two views that look across each other may suffice where their number does not.
  bool asks_pairs() const {
    return !rule_.across.empty() && rule_.least_across < rule_.least_views;
  }
  /// The same, but so that only the number of views that see a point counts.
  SilhouetteField by_number() const;
  /// By number, without one view, and with as many views asked for as are left.
  SilhouetteField without(std::size_t view) const;

  std::size_t view_count() const { return views_.size(); }
  const std::string& name(std::size_t view) const { return camera(view).name; }
  /// The pixels of a view that are hand or unknown: all lie in this box.
  const Eigen::AlignedBox2i& foreground(std::size_t view) const {
    return views_[view].foreground();
  }
  /// The direction in which a view sees the middle of its foreground, in the world.
  Eigen::Vector3d middle_direction(std::size_t view) const;
  const Camera& camera(std::size_t view) const { return views_[view].camera(); }

 private:
  void set_rule(const HullOptions& options);
  /// The views of those before which all of a block is hand that are sure to say more than
  /// largest_value there.
  ViewSet certain_views(const LatticeIndex& low, ViewSet inside) const;

  std::vector<SilhouetteTable> views_;
  SamplingRule rule_;
  std::vector<SampledView> sampled_views_;
  OctreeRoot root_;
  InstructionSet instruction_set_ = best_instruction_set();
};

}  // namespace tegata
