// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "tegata/fit/solver.h"
#include "tegata/hand/shaped_hand.h"

namespace tegata {

/// The surface of some hand and where its joints are, roughly [m], in one frame: the keypoints of
/// keypoint_names(). The surface may be open; what it has behind the wrist counts for nothing.
struct HandSurface {
  TriangleMesh surface;
  std::array<Eigen::Vector3d, kKeypointCount> keypoints;
};

struct SurfaceFitOptions {
  double sigma = 0.010;               ///< of the Lorentzian kernel on surface distances [m]
  double surface_deviation = 0.002;   ///< of a surface point from the other surface [m]
  double point_count = 400.0;         ///< as how many such points a whole surface counts
  double keypoint_deviation = 0.004;  ///< of the keypoints given [m]
  double angle_deviation = 1.0;       ///< of the angles from relaxed ones [rad]
  /// Factor on the deviations of shape_prior(): a modeller's hand is not one of a population.
  double shape_deviation = 3.0;
  int most_iterations = 60;
};

/// The built-in hand in the shape and pose that come nearest to a surface.
struct SurfaceFit {
  ShapeParameters shape;
  HandPose pose;
  HandModel model;  ///< of that shape
  /// Between the two surfaces over what lies beyond the wrist: mean distance from each to the
  /// other, averaged over the two directions, and the 95th percentile of both together [m].
  double mean_distance = 0.0, distance_95 = 0.0;
  std::array<double, kKeypointCount> keypoint_errors = {};  ///< from the keypoints given [m]
  /// Mean over the joints of fingers and thumb, without wrist and tips [m].
  double mean_joint_error = 0.0;
  int iterations = 0;
  Termination termination = Termination::iteration_limit;
};

/// Fits shape, pose and angles at once by damped Gauss-Newton: first to the keypoints alone, then
/// to closest points both ways, point to plane, with the keypoints as a hint and the priors of
/// shape and angles. Throws Error where the surface has no triangles beyond the wrist, or where a
/// keypoint is not finite. Bent fingers are found as well as the keypoints tell.
SurfaceFit fit_surface(const ShapedHand& hand, const HandSurface& given,
                       const SurfaceFitOptions& options = {});

}  // namespace tegata
