// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/camera/camera.h"

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"

namespace tegata {
namespace {

// OpenCV's rational, tangential and thin-prism lens model, from ideal to distorted coordinates on
// the plane z = 1.
Eigen::Vector2d distort_normalized(const Distortion& d, const Eigen::Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y();
  const double r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
  const double radial =
      (1.0 + d[0] * r2 + d[1] * r4 + d[4] * r6) / (1.0 + d[5] * r2 + d[6] * r4 + d[7] * r6);
  return {x * radial + 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x) + d[8] * r2 + d[9] * r4,
          y * radial + d[2] * (r2 + 2.0 * y * y) + 2.0 * d[3] * x * y + d[10] * r2 + d[11] * r4};
}

Eigen::Vector2d undistort_normalized(const Distortion& d, const Eigen::Vector2d& distorted) {
  constexpr int kMostIterations = 100;
  constexpr double kTolerance = 1e-12;
  Eigen::Vector2d ideal = distorted;
  for (int i = 0; i < kMostIterations; ++i) {
    const Eigen::Vector2d error = distort_normalized(d, ideal) - distorted;
    ideal -= error;
    if (error.norm() < kTolerance) break;
  }
  return ideal;
}

Eigen::Vector2d to_normalized(const Camera& camera, const Eigen::Vector2d& pixel) {
  return {(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy};
}

Eigen::Vector2d to_pixel(const Camera& camera, const Eigen::Vector2d& normalized) {
  return {camera.fx * normalized.x() + camera.cx, camera.fy * normalized.y() + camera.cy};
}

}  // namespace

bool Camera::is_distorted() const {
  return std::any_of(distortion.begin(), distortion.end(), [](double c) { return c != 0.0; });
}

Camera Camera::undistorted() const {
  Camera ideal = *this;
  ideal.distortion = {};
  return ideal;
}

std::optional<Eigen::Vector2d> project_camera_point(const Camera& camera,
                                                    const Eigen::Vector3d& point_in_camera) {
  if (point_in_camera.z() <= 0.0) return std::nullopt;
  const Eigen::Vector2d ideal = point_in_camera.hnormalized();
  return to_pixel(camera,
                  camera.is_distorted() ? distort_normalized(camera.distortion, ideal) : ideal);
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
  if (camera.is_distorted()) normalized = undistort_normalized(camera.distortion, normalized);
  return camera.camera_from_world.rotation.conjugate() * normalized.homogeneous().normalized();
}

Eigen::Vector2d distort_pixel(const Camera& camera, const Eigen::Vector2d& undistorted_pixel) {
  return to_pixel(camera,
                  distort_normalized(camera.distortion, to_normalized(camera, undistorted_pixel)));
}

Eigen::Vector2d undistort_pixel(const Camera& camera, const Eigen::Vector2d& pixel) {
  return to_pixel(camera, undistort_normalized(camera.distortion, to_normalized(camera, pixel)));
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
