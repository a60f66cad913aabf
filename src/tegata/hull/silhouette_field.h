// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tegata/hull/block_sampling.h"
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
  const std::string& name(std::size_t view) const { return views_[view].source->camera.name; }
  /// The pixels of a view that are hand or unknown: all lie in this box.
  Eigen::AlignedBox2i foreground(std::size_t view) const { return views_[view].foreground; }
  /// The direction in which a view sees the middle of its foreground, in the world.
  Eigen::Vector3d middle_direction(std::size_t view) const;
  const Camera& camera(std::size_t view) const { return views_[view].source->camera; }

 private:
  struct View {
    const HullView* source = nullptr;
    Eigen::Matrix3d pixel_from_world;  ///< homogeneous, with pixel_offset; third row: depth [m]
    Eigen::Vector3d pixel_offset;
    double width = 0.0, height = 0.0;
    float metres_per_pixel = 0.0f;    ///< at a depth of 1 m
    Eigen::AlignedBox2i foreground;   ///< of pixels that are hand or unknown; empty without any
    std::vector<std::uint32_t> sums;  ///< of such pixels above and left, over the foreground's box
    bool has_unknown = false;
    double rounding = 0.0;  ///< of sample()'s pixels, times the depth [px m]
    int band = 0;           ///< so far from the edge distances are measured [px]
  };
  enum class Verdict : std::uint8_t {
    blind,
    outside,
    outside_as_far_as_seen,
    inside,
    inside_as_far_as_seen,
    undecided
  };
  struct Judgement {
    Verdict verdict = Verdict::undecided;
    bool sees_all = false;
  };
  static View make_view(const HullView& source);
  void set_rule(const HullOptions& options);
  static bool misses_frustum(const View& view, const Eigen::Vector3d& h, double half_side);
  /// Where a cube in front of a camera can be seen.
  struct Footprint {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;  ///< [px]
    /// Whether the picture shows all of it.
    bool is_within(const View& view) const {
      return left >= 0.0 && top >= 0.0 && right <= view.width - 1.0 && bottom <= view.height - 1.0;
    }
  };
  static Footprint footprint(const View& view, const Eigen::Vector3d& h, double half_side);
  /// Whether all pixels that bilinear interpolation reads in a footprint, and those around it, are
  /// hand or unknown; `any` if one is.
  static bool is_all_foreground(const View& view, const Footprint& footprint, int around,
                                bool* any);
  static Judgement judge(const View& view, const Eigen::Vector3d& center, double half_side);
  static std::uint32_t count_foreground(const View& view, const Eigen::AlignedBox2i& pixels);
  static double nearest_depth(const View& view, const OctreeRoot& root);
  static double leaf_reach(const View& view, const OctreeRoot& root);
  static SampledView sampled_view(View& view, const OctreeRoot& root, double largest_value);
  /// The views of those before which all of a block is hand that are sure to say more than
  /// largest_value there.
  ViewSet certain_views(const LatticeIndex& low, ViewSet inside) const;

  std::vector<View> views_;
  SamplingRule rule_;
  std::vector<SampledView> sampled_views_;
  OctreeRoot root_;
  InstructionSet instruction_set_ = best_instruction_set();
};

}  // namespace tegata
