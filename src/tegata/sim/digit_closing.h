// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "tegata/hand/hand_model.h"
#include "tegata/math/rigid3d.h"
#include "tegata/sim/held_object.h"

namespace tegata {

/// An object where it lies in the hand.
struct PlacedObject {
  HeldObject object;
  Rigid3d hand_from_object;

  double distance(const Eigen::Vector3d& point_in_hand) const {
    return signed_distance(object, object_from_hand() * point_in_hand);
  }
  Rigid3d object_from_hand() const { return hand_from_object.inverse(); }
};

/// The vertices of a hand that one digit (0 the thumb ... 4 the little finger) moves most, ready to
/// be bent quickly. Keeps a reference to the model, which must outlive it.
class DigitSurface {
 public:
  DigitSurface(const HandModel& hand, int digit);

  int digit() const { return digit_; }
  /// The least distance [m] of the vertices of each of the digit's three bones to the object:
  /// negative where they are inside. The ball of the thumb does not count.
  std::array<double, 3> clearances(const JointAngles& angles, const PlacedObject& object) const;
  /// How far a bone's vertices lie from its axis [m], on average.
  double radius(int bone_of_digit) const { return radii_[static_cast<std::size_t>(bone_of_digit)]; }

 private:
  struct Vertex {
    int bone_of_digit = 0;
    std::array<Eigen::Vector3d, 4> at_zero;  ///< before each link's bone is turned, hand frame
    SkinLinks links;
  };
  const HandModel* hand_;
  int digit_;
  std::vector<Vertex> vertices_;
  std::array<double, 3> radii_ = {};
};

/// How a digit shall come to rest on an object.
struct DigitGoal {
  Eigen::Vector4d preferred =
      Eigen::Vector4d::Zero();  ///< its angles, where contact is silent [rad]
  Eigen::Vector4d stiffness = {0.05, 0.006, 0.006, 0.02};  ///< [mm^2 / deg^2]
  Eigen::Vector3d contact = {0.2, 0.5, 1.0};  ///< how much each bone's gap counts, near bone first
  std::optional<Eigen::Vector3d> tip_target;  ///< where the fingertip shall be, hand frame [m]
};

/// Bends one digit, the others staying as `angles` has them, until it rests on the object: the
/// minimum, within the joint limits, of gaps, depth of penetration beyond a soft pad's, overlap
/// with digits of `others`, distance from the target and from the preferred angles. A compass
/// search from the preferred angles and from a more open digit; deterministic.
JointAngles closed_digit(const HandModel& hand, const DigitSurface& digit,
                         const std::vector<const DigitSurface*>& others, const DigitGoal& goal,
                         const PlacedObject& object, const JointAngles& angles);

}  // namespace tegata
