// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/camera/camera.h"

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"

namespace tegata {
namespace {

Eigen::Vector2d to_normalized(const Camera& camera, const Eigen::Vector2d& pixel) {
  return {(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy};
}

Eigen::Vector2d to_pixel(const Camera& camera, const Eigen::Vector2d& normalized) {
  return {camera.fx * normalized.x() + camera.cx, camera.fy * normalized.y() + camera.cy};
}

}  // namespace

bool Camera::is_distorted() const { return !lens().is_ideal(); }

Camera Camera::undistorted() const {
  Camera ideal = *this;
  ideal.lens_model = LensModel::perspective;
  ideal.distortion = {};
  return ideal;
}

std::optional<Eigen::Vector2d> project_camera_point(const Camera& camera,
                                                    const Eigen::Vector3d& point_in_camera) {
  if (point_in_camera.z() <= 0.0) return std::nullopt;
  const Eigen::Vector2d ideal = point_in_camera.hnormalized();
  return to_pixel(camera, camera.is_distorted() ? camera.lens().distort(ideal) : ideal);
}

std::optional<Eigen::Vector2d> project(const Camera& camera,
                                       const Eigen::Vector3d& point_in_world) {
  return project_camera_point(camera, camera.camera_from_world * point_in_world);
}

Eigen::Matrix<double, 2, 3> project_jacobian(const Camera& camera,
                                             const Eigen::Vector3d& point_in_world) {
  const Eigen::Vector3d p = camera.camera_from_world * point_in_world;
  const double inverse_depth = 1.0 / p.z();
  Eigen::Matrix<double, 2, 3> by_camera_point;
  by_camera_point << camera.fx * inverse_depth, 0.0,
      -camera.fx * p.x() * inverse_depth * inverse_depth, 0.0, camera.fy * inverse_depth,
      -camera.fy * p.y() * inverse_depth * inverse_depth;
  return by_camera_point * camera.camera_from_world.rotation.toRotationMatrix();
}

Eigen::Vector3d pixel_direction(const Camera& camera, const Eigen::Vector2d& pixel) {
  Eigen::Vector2d normalized = to_normalized(camera, pixel);
  if (camera.is_distorted()) normalized = camera.lens().undistort(normalized);
  return camera.camera_from_world.rotation.conjugate() * normalized.homogeneous().normalized();
}

Eigen::Vector2d distort_pixel(const Camera& camera, const Eigen::Vector2d& undistorted_pixel) {
  return to_pixel(camera, camera.lens().distort(to_normalized(camera, undistorted_pixel)));
}

Eigen::Vector2d undistort_pixel(const Camera& camera, const Eigen::Vector2d& pixel) {
  return to_pixel(camera, camera.lens().undistort(to_normalized(camera, pixel)));
}

void check_camera(const Camera& camera) {
  const std::string where = text("camera '", camera.name, "': ");
  if (camera.width <= 0 || camera.height <= 0) {
    throw Error(where, "got a size of ", camera.width, " x ", camera.height,
                ", expected a width and a height in pixels");
  }
  const bool finite = std::isfinite(camera.cx) && std::isfinite(camera.cy) &&
                      camera.camera_from_world.rotation.coeffs().allFinite() &&
                      camera.camera_from_world.translation.allFinite() &&
                      std::all_of(camera.distortion.begin(), camera.distortion.end(),
                                  [](double c) { return std::isfinite(c); });
  if (!finite) throw Error(where, "got a number that is not finite, expected finite calibration");
  if (!(camera.fx > 0.0 && camera.fy > 0.0 && std::isfinite(camera.fx * camera.fy))) {
    throw Error(where, "got focal lengths ", camera.fx, " and ", camera.fy,
                ", expected positive numbers of pixels");
  }
}

void check_rig(const CameraRig& rig) {
  if (rig.size() < 2) {
    throw Error("calibration: got ", rig.size(), " cameras, expected 2 or more");
  }
  for (std::size_t i = 0; i < rig.size(); ++i) {
    check_camera(rig[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (rig[i].name == rig[j].name) {
        throw Error("calibration: got two cameras named '", rig[i].name,
                    "', expected a name of its own for each");
      }
    }
  }
}

}  // namespace tegata
