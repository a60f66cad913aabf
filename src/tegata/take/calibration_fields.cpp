// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_fields.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tegata/base/error.h"

namespace tegata {
namespace {

template <typename Got>
[[noreturn]] void fail(std::string_view where, const Got& got, std::string_view expected) {
  throw Error(where, ": got ", got, ", expected ", expected);
}

int whole_pixels(double value, std::string_view where) {
  if (!(value >= 1.0 && value <= std::numeric_limits<int>::max()) || value != std::floor(value)) {
    fail(where, value, "whole numbers of pixels above 0");
  }
  return static_cast<int>(value);
}

bool all_zero(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0; });
}

}  // namespace

void set_size(Camera& camera, double width, double height, std::string_view where) {
  camera.width = whole_pixels(width, where);
  camera.height = whole_pixels(height, where);
}

void set_matrix(Camera& camera, const Eigen::Matrix3d& k, std::string_view where) {
  constexpr double kTolerance = 1e-6;  // of the focal length, or of 1 in the last row
  if ((k.row(2) - Eigen::RowVector3d(0.0, 0.0, 1.0)).cwiseAbs().maxCoeff() > kTolerance) {
    fail(where, text("the last row ", k(2, 0), " ", k(2, 1), " ", k(2, 2)), "0 0 1");
  }
  if (!(k(0, 0) > 0.0 && k(1, 1) > 0.0)) {
    fail(where, text("focal lengths ", k(0, 0), " and ", k(1, 1)),
         "positive numbers of pixels on the diagonal");
  }
  const double skew = std::max(std::abs(k(0, 1)), std::abs(k(1, 0)));
  if (skew > kTolerance * k(0, 0)) {
    fail(where, text("a skew of ", skew), "0 beside the focal lengths");
  }
  camera.fx = k(0, 0);
  camera.fy = k(1, 1);
  camera.cx = k(0, 2);
  camera.cy = k(1, 2);
}

void set_distortion(Camera& camera, LensModel model, std::span<const double> values,
                    std::string_view where) {
  camera.lens_model = model;
  camera.distortion = {};
  std::size_t count = values.size();
  if (model == LensModel::fisheye) {
    if (count > 4 && all_zero(values.subspan(4))) count = 4;
    if (count != 0 && count != 4) {
      fail(where, text(count, " numbers"), "0 or 4 numbers, k1 to k4 of a fisheye lens");
    }
  } else {
    // OpenCV's 14 are the 12 and the tilt of the sensor, which is not modelled.
    if (count == 14 && all_zero(values.subspan(12))) count = 12;
    constexpr std::array<std::size_t, 5> kCounts = {0, 4, 5, 8, 12};
    if (std::find(kCounts.begin(), kCounts.end(), count) == kCounts.end()) {
      fail(where, text(count, " numbers"),
           "0, 4, 5, 8 or 12 numbers in the order of OpenCV, or 14 of which the last two are 0");
    }
  }
  std::copy_n(values.begin(), count, camera.distortion.begin());
}

Eigen::Quaterniond rotation_from_matrix(const Eigen::Matrix3d& matrix, std::string_view where) {
  constexpr double kTolerance = 1e-3;
  const double off =
      (matrix * matrix.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= kTolerance)) {
    fail(where, text("a matrix that is ", off, " off a rotation"),
         "rows that are orthogonal and of length 1");
  }
  if (matrix.determinant() < 0.0) {
    fail(where, "a rotation that mirrors", "a matrix of determinant +1");
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Eigen::Quaterniond(svd.matrixU() * svd.matrixV().transpose()).normalized();
}

void check_camera_name(std::string_view name, std::string_view where) {
  if (name.empty() || name.find('/') != std::string_view::npos || name.front() == '.') {
    fail(where, text("'", name, "'"), "a name that a folder or a video can have");
  }
}

void check_rig_of_file(const CameraRig& rig, const std::string& file) {
  try {
    check_rig(rig);
  } catch (const Error& error) {
    throw Error(file, ": ", error.what());
  }
}

}  // namespace tegata
