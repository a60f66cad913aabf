// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/camera/camera.h"

#include <gtest/gtest.h>

#include <limits>

#include "tegata/base/error.h"
#include "tegata/math/finite_difference.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

Camera distorted_camera() {
  Camera camera;
  camera.name = "left";
  camera.width = 640;
  camera.height = 480;
  camera.fx = 800.0;
  camera.fy = 790.0;
  camera.cx = 322.0;
  camera.cy = 236.0;
  camera.distortion = {-0.25, 0.1, 0.001, -0.002, -0.01};
  camera.camera_from_world = {so3_exp({0.1, 2.0, -0.4}), {0.1, 0.2, 1.5}};
  return camera;
}

TEST(Camera, APixelsDirectionProjectsBackToThePixel) {
  const Camera camera = distorted_camera();
  for (const Eigen::Vector2d& pixel :
       {Eigen::Vector2d(5.0, 470.0), Eigen::Vector2d(322.0, 236.0), Eigen::Vector2d(600.0, 20.0)}) {
    const Eigen::Vector3d point = camera.center_in_world() + 2.0 * pixel_direction(camera, pixel);
    const auto back = project(camera, point);
    ASSERT_TRUE(back.has_value());
    EXPECT_LT((*back - pixel).norm(), 1e-8);
    EXPECT_LT((distort_pixel(camera, undistort_pixel(camera, pixel)) - pixel).norm(), 1e-8);
  }
}

TEST(Camera, ProjectsByOpenCvsFormula) {
  Camera camera = distorted_camera();
  camera.camera_from_world = {};
  camera.distortion = {0.1, -0.2, 0.01, 0.02, 0.3};
  // x' = 0.2, y' = -0.1, r^2 = 0.05; each term written out from OpenCV's documentation.
  const double radial = 1.0 + 0.1 * 0.05 - 0.2 * 0.0025 + 0.3 * 0.000125;
  const double x = 0.2 * radial + 2 * 0.01 * 0.2 * -0.1 + 0.02 * (0.05 + 2 * 0.04);
  const double y = -0.1 * radial + 0.01 * (0.05 + 2 * 0.01) + 2 * 0.02 * 0.2 * -0.1;
  const auto pixel = project(camera, {0.4, -0.2, 2.0});
  ASSERT_TRUE(pixel.has_value());
  EXPECT_NEAR(pixel->x(), 800.0 * x + 322.0, 1e-9);
  EXPECT_NEAR(pixel->y(), 790.0 * y + 236.0, 1e-9);
}

TEST(Camera, DoesNotSeeWhatIsBehindIt) {
  const Camera camera = distorted_camera();
  const Eigen::Vector3d backward =
      camera.camera_from_world.rotation.conjugate() * Eigen::Vector3d(0.0, 0.0, -1.0);
  EXPECT_FALSE(project(camera, camera.center_in_world() + backward).has_value());
}

TEST(Camera, JacobianOfTheProjectionIsTheFiniteDifference) {
  const Camera camera = distorted_camera().undistorted();
  const Eigen::Vector3d point =
      camera.center_in_world() + 1.2 * pixel_direction(camera, {200.0, 300.0});
  const auto function = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return *project(camera, Eigen::Vector3d(x));
  };
  const Eigen::MatrixXd expected = finite_difference_jacobian(function, point);
  EXPECT_LT((project_jacobian(camera, point) - expected).norm(), 1e-4);
}

TEST(Camera, RefusesNumbersThatAreNotFiniteAndSizesOfNothing) {
  Camera camera = distorted_camera();
  camera.distortion[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_camera(camera), Error);
  camera = distorted_camera();
  camera.fx = 0.0;
  EXPECT_THROW(check_camera(camera), Error);
  camera = distorted_camera();
  camera.height = 0;
  EXPECT_THROW(check_camera(camera), Error);
  EXPECT_NO_THROW(check_camera(distorted_camera()));
}

TEST(CameraRig, RefusesOneCameraAndTwoOfTheSameName) {
  EXPECT_THROW(check_rig({distorted_camera()}), Error);
  EXPECT_THROW(check_rig({distorted_camera(), distorted_camera()}), Error);
}

}  // namespace
}  // namespace tegata
