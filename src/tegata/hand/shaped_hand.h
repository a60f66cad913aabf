// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tegata/hand/hand_model.h"
#include "tegata/hand/hand_shape.h"
#include "tegata/hand/shape_parameters.h"

namespace tegata {

struct BuiltInHandOptions {
  double cell_size = 0.0025;  ///< of the octree that the mean hand is meshed on [m]
  std::size_t triangle_count = 3000;
};

/// d point / d shape parameters.
using ShapeJacobian = Eigen::Matrix<double, 3, kShapeParameterCount>;

/// How a hand's rest surface and joints move with its shape parameters.
struct ShapeBasis {
  std::vector<ShapeJacobian> vertices;                  ///< of the rest surface
  std::array<ShapeJacobian, kKeypointCount> keypoints;  ///< of the skeleton, at zero angles
};

/// The built-in hand in all shapes: the mean hand is meshed once, and every vertex moves with the
/// bones that it is linked to, along each by its length and across by its digit's thickness, in the
/// palm by its breadth, length and thickness. So the triangles and links stay what they are, and
/// vertices and joints are linear in the ShapeDrivers. Constant once made.
class ShapedHand {
 public:
  /// Throws Error for cells too coarse for a finger.
  explicit ShapedHand(Side side, const BuiltInHandOptions& options = {});

  Side side() const { return side_; }
  /// The hand of a shape; throws Error where check_shape() does.
  HandModel model(const HandShape& shape) const;
  /// Derivatives at the shape of these parameters.
  ShapeBasis basis(const ShapeParameters& parameters) const;

 private:
  /// d point / d drivers.
  using DriverJacobian = Eigen::Matrix<double, 3, kShapeDriverCount>;

  Side side_;
  HandModel mean_;  ///< of the right hand
  std::vector<DriverJacobian> vertices_;
  std::array<DriverJacobian, kKeypointCount> keypoints_;
};

/// The derivatives of a posed hand by its shape.
class PosedShape {
 public:
  /// Of a model with the basis at its shape, in a pose. Keeps references to model and basis, which
  /// must outlive it.
  PosedShape(const HandModel& model, const ShapeBasis& basis, const HandPose& pose);

  /// d vertex in world / d shape parameters.
  ShapeJacobian vertex_jacobian(std::size_t vertex) const;
  /// d keypoint in world / d shape parameters.
  const ShapeJacobian& keypoint_jacobian(int keypoint) const {
    return keypoints_[static_cast<std::size_t>(keypoint)];
  }

 private:
  const HandModel* model_;
  const ShapeBasis* basis_;
  std::array<Eigen::Matrix3d, kBoneCount> turns_;  ///< of each bone, from rest to world
  std::array<ShapeJacobian, kBoneCount> shifts_;   ///< what is left of a bone's own movement
  std::array<ShapeJacobian, kKeypointCount> keypoints_;
};

}  // namespace tegata
