// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What the readers of all calibration formats ask of a camera's numbers. `where` opens the message
// of an Error: the file, the camera and the key.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <string>
#include <string_view>

#include "tegata/camera/camera.h"

namespace tegata {

/// Whole numbers above 0.
void set_size(Camera& camera, double width, double height, std::string_view where);
/// Positive focal lengths on the diagonal, no skew, last row 0 0 1.
void set_matrix(Camera& camera, const Eigen::Matrix3d& matrix, std::string_view where);
/// OpenCV's coefficients: 0, 4, 5, 8, 12 or, of a sensor that is not tilted, 14 for a perspective
/// lens; 0 or 4 for a fisheye (or more, the others zero).
void set_distortion(Camera& camera, LensModel model, std::span<const double> coefficients,
                    std::string_view where);
/// The nearest rotation to a matrix that was written with few digits. Throws Error where it is no
/// rotation or mirrors.
Eigen::Quaterniond rotation_from_matrix(const Eigen::Matrix3d& matrix, std::string_view where);
/// The name of a camera is that of a folder or of a video.
void check_camera_name(std::string_view name, std::string_view where);
/// check_rig() whose Error names the file.
void check_rig_of_file(const CameraRig& rig, const std::string& file);

}  // namespace tegata
