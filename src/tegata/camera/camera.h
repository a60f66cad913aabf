// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "tegata/camera/lens.h"
#include "tegata/math/rigid3d.h"

namespace tegata {

/// A calibrated camera in OpenCV's frame (x right, y down, z forward). Pixel (0, 0) is the centre
/// of the top left pixel, so the picture covers [-0.5, width - 0.5) x [-0.5, height - 0.5).
struct Camera {
  std::string name;
  int width = 0;                                  ///< pixels
  int height = 0;                                 ///< pixels
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;  ///< pixels
  Distortion distortion = {};
  Rigid3d camera_from_world;
  LensModel lens_model = LensModel::perspective;  ///< says what `distortion` means

  Lens lens() const { return {lens_model, distortion}; }
  /// Where the camera stands.
  Eigen::Vector3d center_in_world() const { return camera_from_world.inverse().translation; }
  bool is_distorted() const;
  /// The same camera with an ideal lens: what undistorted pictures belong to.
  Camera undistorted() const;
  /// Whether a pixel position lies within the picture.
  bool contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 &&
           pixel.y() < height - 0.5;
  }
};

/// The pixel position of a point, or nothing where the point is not in front of the camera.
std::optional<Eigen::Vector2d> project(const Camera& camera, const Eigen::Vector3d& point_in_world);

/// The same for a point in the camera's frame.
std::optional<Eigen::Vector2d> project_camera_point(const Camera& camera,
                                                    const Eigen::Vector3d& point_in_camera);

/// d pixel / d point_in_world (2 x 3) of an undistorted camera for a point in front of it.
Eigen::Matrix<double, 2, 3> project_jacobian(const Camera& camera,
                                             const Eigen::Vector3d& point_in_world);

/// The direction (unit, world frame) that a pixel of the camera's picture looks along. Undistortion
/// iterates to convergence; outside the range where the lens model is invertible the answer is the
/// last iterate.
Eigen::Vector3d pixel_direction(const Camera& camera, const Eigen::Vector2d& pixel);

/// Where a pixel of camera.undistorted() lies in the picture of the distorted camera.
Eigen::Vector2d distort_pixel(const Camera& camera, const Eigen::Vector2d& undistorted_pixel);

/// Where a pixel of the distorted camera lies in the picture of camera.undistorted().
Eigen::Vector2d undistort_pixel(const Camera& camera, const Eigen::Vector2d& pixel);

/// Throws Error naming the camera and what is wrong with it: a size that is not positive, numbers
/// that are not finite, focal lengths that are not positive.
void check_camera(const Camera& camera);

/// The cameras of a recording, in the order of its calibration file. At least two, names unique.
using CameraRig = std::vector<Camera>;

/// Checks every camera, that there are two or more and that no two share a name; throws Error.
void check_rig(const CameraRig& rig);

}  // namespace tegata
