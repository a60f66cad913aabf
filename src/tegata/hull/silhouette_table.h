// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "tegata/hull/block_sampling.h"
#include "tegata/hull/visual_hull.h"

namespace tegata {

/// What one view's silhouette shows of a cube in the world, by a summed-area table (Crow 1984) of
/// its foreground: the pixels that are hand or unknown. Refers to the view, which must outlive it.
class SilhouetteTable {
 public:
  explicit SilhouetteTable(const HullView& view);

  const Camera& camera() const { return source_->camera; }
  /// All foreground lies in this box; empty without any.
  const Eigen::AlignedBox2i& foreground() const { return foreground_; }
  bool has_hand() const { return has_hand_; }
  bool has_unknown() const { return has_unknown_; }

  enum class Verdict : std::uint8_t {
    blind,                   ///< sees nothing of the cube
    outside,                 ///< sees all of it, before the background
    outside_as_far_as_seen,  ///< as outside, but the picture cuts it off
    inside,                  ///< sees all of it, before the foreground
    inside_as_far_as_seen,
    undecided
  };
  struct Judgement {
    Verdict verdict = Verdict::undecided;
    bool sees_all = false;
  };
  Judgement judge(const Eigen::Vector3d& center, double half_side) const;

  /// How far inside the silhouette's edge the corner of a leaf can lie of which another corner is
  /// outside it [m].
  double leaf_reach(const OctreeRoot& root) const;
  /// What block_sampling.h asks of the view, with distances that are right up to `largest_value`
  /// [m]. From here on judge() leaves room for sample_block()'s rounding.
  SampledView prepare_sampling(const OctreeRoot& root, double largest_value);
  /// Whether all of a cube, which judge() calls inside, is sure to be farther inside the edge than
  /// prepare_sampling()'s largest value, and nothing unknown is near.
  bool is_surely_inside(const Eigen::Vector3d& center, double half_side) const;

 private:
  /// Where a cube in front of the camera can be seen.
  struct Footprint {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;  ///< [px]
  };
  void find_foreground();
  void sum_foreground();
  Eigen::Vector3d project(const Eigen::Vector3d& point) const {
    return pixel_from_world_ * point + pixel_offset_;
  }
  double nearest_depth(const OctreeRoot& root) const;
  bool misses_frustum(const Eigen::Vector3d& h, double half_side) const;
  Footprint footprint(const Eigen::Vector3d& h, double half_side) const;
  struct Count {
    std::uint32_t foreground = 0, pixels = 0;
  };
  Count count(const Footprint& footprint, int around) const;

  const HullView* source_;
  Eigen::Matrix3d pixel_from_world_;  ///< homogeneous, with pixel_offset_; third row: depth [m]
  Eigen::Vector3d pixel_offset_;
  double depth_reach_ = 0.0;       ///< of a cube of half side 1, to either side of its middle
  float metres_per_pixel_ = 0.0f;  ///< at a depth of 1 m
  Eigen::AlignedBox2i foreground_;
  std::vector<std::uint32_t> sums_;  ///< of foreground above and left, over its box
  bool has_hand_ = false, has_unknown_ = false;
  double rounding_ = 0.0;       ///< of sampled pixels, times the depth [px m]
  double largest_value_ = 0.0;  ///< [m]
  int band_ = 0;                ///< so far from the edge distances are measured [px]
};

}  // namespace tegata
