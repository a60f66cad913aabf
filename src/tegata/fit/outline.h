// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/shape_motion.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// A point of the posed hand where its surface turns away from a camera and that lies on the border
/// of what the camera sees of it.
struct OutlinePoint {
  std::uint32_t a = 0, b = 0;  ///< the ends of the surface edge that it lies on
  double fraction = 0.0;       ///< from a to b
  Eigen::Vector3d point;       ///< world [m]
  Eigen::Vector2d pixel;
  Eigen::Vector2d normal;  ///< in the picture, unit, away from the hand
  bool beyond_wrist = true;
};

/// How far each vertex faces a camera: the product of its normal and the way there [m]. The surface
/// turns away where it falls through zero.
std::vector<double> facing_camera(const PosedHand& posed, const Camera& camera);

/// The outline of the hand in a camera without distortion. Found on the edges of the surface along
/// which the normal passes from towards the camera to away from it; of these, those with the hand
/// on one side in the picture and nothing on the other. Points that the picture does not show are
/// left out. Sorted by the pixels' x. What is on either side is looked up in a picture of the hand
/// that is `coarseness` times smaller than the camera's.
std::vector<OutlinePoint> hand_outline(const FitHand& hand, const PosedHand& posed,
                                       const Camera& camera, int coarseness = 1);

/// d (along . point) / d pose and angles.
HandRow outline_row(const PosedHand& posed, const OutlinePoint& point,
                    const Eigen::RowVector3d& along);
/// d (along . point) / d shape; empty without a shape.
ShapeRow outline_shape_row(const ShapeMotion* shape, const OutlinePoint& point,
                           const Eigen::RowVector3d& along);

}  // namespace tegata
