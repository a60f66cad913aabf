// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/room_cameras.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"

namespace tegata {
namespace {

double angle_between_deg(const Camera& a, const Camera& b) {
  const double cosine = a.center_in_world().normalized().dot(b.center_in_world().normalized());
  return std::acos(cosine) * kDegreesPerRadian;
}

TEST(RoomCameras, AllLookAtTheMiddleFromInsideTheRoomUpright) {
  for (const int count : {2, 3, 4, 8}) {
    const CameraRig rig = room_cameras({.count = count, .seed = 5});
    ASSERT_EQ(rig.size(), static_cast<std::size_t>(count));
    check_rig(rig);
    for (const Camera& camera : rig) {
      const auto middle = project(camera, Eigen::Vector3d::Zero());
      ASSERT_TRUE(middle.has_value());
      EXPECT_LT((*middle - Eigen::Vector2d(319.5, 239.5)).norm(), 40.0);
      const Eigen::Vector3d place = camera.center_in_world();
      EXPECT_LE(place.head<2>().cwiseAbs().maxCoeff(), 0.75);
      EXPECT_LE(std::abs(place.z()), 1.0);
      EXPECT_GT(place.norm(), 0.7);
      if (std::abs(place.z()) < 0.5) {  // what is higher in the room is higher in the picture
        EXPECT_LT(project(camera, {0.0, 0.0, 0.05})->y(), middle->y());
      }
    }
  }
}

TEST(RoomCameras, ThreeStandOnOrthogonalAxes) {
  const CameraRig rig = room_cameras({.count = 3, .seed = 9});
  EXPECT_NEAR(angle_between_deg(rig[0], rig[1]), 90.0, 12.0);
  EXPECT_NEAR(angle_between_deg(rig[0], rig[2]), 90.0, 12.0);
  EXPECT_NEAR(angle_between_deg(rig[1], rig[2]), 90.0, 12.0);
}

TEST(RoomCameras, NoTwoLookTheSameWay) {
  for (const int count : {2, 4, 6, 10}) {
    const CameraRig rig = room_cameras({.count = count, .seed = 2});
    for (std::size_t i = 0; i < rig.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_GT(angle_between_deg(rig[i], rig[j]), 25.0);
    }
  }
}

TEST(RoomCameras, HandTakesHalfOfThePicture) {
  for (const Camera& camera : room_cameras({.count = 3, .seed = 3})) {
    const Eigen::Vector3d across =
        camera.camera_from_world.rotation.conjugate() * Eigen::Vector3d(0.095, 0.0, 0.0);
    const double length = (*project(camera, across) - *project(camera, -across)).norm();
    EXPECT_GT(length, 200.0);
    EXPECT_LT(length, 260.0);
  }
}

TEST(RoomCameras, SeedDecidesAndLensIsIdealWhereAsked) {
  const CameraRig a = room_cameras({.seed = 1}), b = room_cameras({.seed = 1});
  const CameraRig c = room_cameras({.distortion = false, .seed = 2});
  EXPECT_EQ(a[0].fx, b[0].fx);
  EXPECT_NE(a[0].fx, c[0].fx);
  EXPECT_TRUE(a[0].is_distorted());
  EXPECT_NE(a[0].distortion, a[1].distortion);
  EXPECT_FALSE(c[0].is_distorted());
}

TEST(RoomCameras, FewerThanTwoIsAnError) {
  EXPECT_THROW(room_cameras({.count = 1}), Error);
  EXPECT_THROW(room_cameras({.width = 0}), Error);
}

}  // namespace
}  // namespace tegata
