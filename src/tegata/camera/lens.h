// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace tegata {

/// How a lens bends rays.
enum class LensModel {
  perspective,  ///< OpenCV's rational, tangential and thin-prism polynomials on the plane z = 1
  fisheye,      ///< OpenCV's fisheye, Kalibr's equidistant: a polynomial of the angle off the axis
};
std::string_view lens_model_name(LensModel model);

/// Coefficients in OpenCV's order, absent ones zero. Perspective: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3
/// s4. Fisheye: k1 k2 k3 k4, and no others.
using Distortion = std::array<double, 12>;

/// What a lens does to directions, given on the plane z = 1.
struct Lens {
  LensModel model = LensModel::perspective;
  Distortion coefficients = {};

  /// Whether it moves anything; a fisheye lens always does.
  bool is_ideal() const;
  /// Where the ideal position (x / z, y / z) comes to lie.
  Eigen::Vector2d distort(const Eigen::Vector2d& ideal) const;
  /// The inverse, iterated to convergence. Beyond the range where the lens is invertible the
  /// perspective model gives its last iterate; fisheye gives at most 89 degrees off the axis.
  Eigen::Vector2d undistort(const Eigen::Vector2d& distorted) const;
  /// The radius at which a point of radius `ideal` comes to lie, by the radial terms alone.
  double distorted_radius(double ideal) const;
};

}  // namespace tegata
