// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "tegata/hand/hand_shape.h"

namespace tegata {

/// The hull of two balls, flattened along one direction by a factor. Its field is positive inside
/// and never steeper than 1; without flattening it is the distance to the surface.
class RoundedCone {
 public:
  /// From a ball of `radius_a` about `a` to one of `radius_b` about `b` [m]; one must not hold the
  /// other. Along the unit vector `flat` all is multiplied by `flatness`, about the line a b.
  struct Ends {
    Eigen::Vector3d a, b;
    double radius_a = 0.0, radius_b = 0.0;
  };
  RoundedCone(const Ends& ends, const Eigen::Vector3d& flat, double flatness);

  double field(const Eigen::Vector3d& point) const;
  Eigen::AlignedBox3d box() const { return box_; }

 private:
  Eigen::Vector3d a_, along_, flat_;
  double length_, radius_, taper_, lean_, stretch_, steepness_;
  Eigen::AlignedBox3d box_;
};

/// The hand as a solid: cones along the bones of the palm, of the forearm's stump and of each
/// digit, run together smoothly; digits run into the palm but not into each other.
class HandSolid {
 public:
  /// The solid of the mean right hand (the default HandShape, whose skeleton this is) in the hand's
  /// frame, bent as the angles say.
  HandSolid(const Skeleton& skeleton, const JointAngles& angles);

  /// Positive inside, nowhere steeper than 1 [m].
  double field(const Eigen::Vector3d& point) const;
  /// Holds the whole solid.
  Eigen::AlignedBox3d box() const;

 private:
  void add_palm();
  void add_finger(const Skeleton& skeleton, const std::array<Rigid3d, kBoneCount>& transforms,
                  std::size_t digit);
  void add_thumb(const Skeleton& skeleton, const std::array<Rigid3d, kBoneCount>& transforms);

  std::vector<RoundedCone> palm_;
  std::array<std::vector<RoundedCone>, kDigitCount> digits_;
  double forearm_end_ = 0.0;  ///< y where the stump is cut off [m]
};

}  // namespace tegata
