// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "tegata/camera/camera.h"

namespace tegata {

/// A point of the board that a camera saw in a frame.
struct BoardObservation {
  std::size_t camera = 0, frame = 0;
  Eigen::Vector3d point_in_board;  ///< [m]
  Eigen::Vector2d pixel;
};

struct BundleOptions {
  /// The scale of the robust (Cauchy) loss: residuals far beyond it hardly count [px].
  double loss_scale = 1.0;
  bool refine_intrinsics = true;
  int most_iterations = 200;
};

/// Weak priors keep what the views leave open of a lens near that of usual ones. Moves cameras
/// (intrinsics, five lens coefficients, poses) and the board's poses in the world to where the
/// observations are reprojected best. Camera 0 stays where it is. Uses Ceres on one thread: the
/// same input gives the same bits. Lenses are perspective ones. Returns, by camera, the standard
/// deviation of the lens's centre along its worse axis if points are 1 px off [px]; 0 for lenses
/// that are not refined and for cameras without observations.
std::vector<double> adjust_bundle(CameraRig& rig, std::vector<Rigid3d>& world_from_board,
                                  const std::vector<BoardObservation>& observations,
                                  const BundleOptions& options);

}  // namespace tegata
