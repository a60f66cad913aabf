// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/room_cameras.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

// The room of the paper, VI, halved.
const Eigen::Array3d kHalfRoom(0.75, 0.75, 1.0);
// A hand of this length takes this share of the picture's height where it stands in the middle.
constexpr double kHandLength = 0.19;
constexpr double kHandShare = 0.47;

// Unit vectors from the room's middle to the cameras.
std::vector<Eigen::Vector3d> directions_to_cameras(int count, Random& random) {
  if (count == 3) {
    return {-Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()};
  }
  const auto direction = [](double azimuth, double height) {
    const double level = std::sqrt(1.0 - height * height);
    return Eigen::Vector3d(level * std::cos(azimuth), level * std::sin(azimuth), height);
  };
  if (count == 2) {
    const double apart = random.uniform(65.0, 85.0) * kDegree;
    return {direction(-std::numbers::pi / 2.0, 0.0),
            direction(-std::numbers::pi / 2.0 + apart, 0.0)};
  }
  // A Fibonacci lattice (Gonzalez 2010) over the part of the sphere above a table's height.
  constexpr double kLowest = -0.2;
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double height = 1.0 - (1.0 - kLowest) * (i + 0.5) / count;
    directions.push_back(direction(i * golden_angle, height));
  }
  return directions;
}

// x right, y down, z forward for a camera that stands at `place` and looks at `target`.
Eigen::Quaterniond looking_at(const Eigen::Vector3d& place, const Eigen::Vector3d& target) {
  const Eigen::Vector3d forward = (target - place).normalized();
  const Eigen::Vector3d up =
      std::abs(forward.z()) > 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d camera_from_world;
  camera_from_world.row(0) = forward.cross(up).normalized();
  camera_from_world.row(1) = forward.cross(camera_from_world.row(0).transpose());
  camera_from_world.row(2) = forward;
  return Eigen::Quaterniond(camera_from_world);
}

Camera camera_towards_middle(const Eigen::Vector3d& direction, const RoomCameraOptions& options,
                             Random& random) {
  const auto some = [&](double most) { return random.uniform(-most, most); };
  const Eigen::Vector3d away =
      so3_exp(Eigen::Vector3d(some(4.0), some(4.0), some(4.0)) * kDegree) * direction;
  const double to_wall = (kHalfRoom / away.array().abs().max(1e-9)).minCoeff();
  const Eigen::Vector3d place = (to_wall - random.uniform(0.0, 0.03)) * away;
  const Eigen::Vector3d target(some(0.008), some(0.008), some(0.008));

  Camera camera;
  camera.width = options.width;
  camera.height = options.height;
  camera.camera_from_world.rotation =
      so3_exp(Eigen::Vector3d(0.0, 0.0, some(4.0) * kDegree)) * looking_at(place, target);
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * place);
  const double shorter_side = std::min(options.height, options.width * 3 / 4);
  camera.fx = kHandShare * shorter_side / kHandLength * place.norm() * random.uniform(0.95, 1.05);
  camera.fy = camera.fx * random.uniform(0.998, 1.002);
  camera.cx = 0.5 * (options.width - 1) + some(0.015) * options.width;
  camera.cy = 0.5 * (options.height - 1) + some(0.015) * options.height;
  const double k1 = random.uniform(-0.2, -0.1), k2 = random.uniform(0.0, 0.05);
  const double p1 = some(1e-3), p2 = some(1e-3);
  if (options.distortion) camera.distortion = {k1, k2, p1, p2};
  return camera;
}

}  // namespace

CameraRig room_cameras(const RoomCameraOptions& options) {
  if (options.count < 2) {
    throw Error("simulated take: got ", options.count, " cameras, expected 2 or more");
  }
  if (options.width < 8 || options.height < 8) {
    throw Error("simulated take: got pictures of ", options.width, " x ", options.height,
                " pixels, expected 8 x 8 or more");
  }
  Random random(options.seed);
  CameraRig rig;
  for (const Eigen::Vector3d& direction : directions_to_cameras(options.count, random)) {
    rig.push_back(camera_towards_middle(direction, options, random));
    rig.back().name = text("camera_", rig.size() - 1);
  }
  return rig;
}

}  // namespace tegata
