// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/infrared_camera.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/sim/held_object.h"

namespace tegata {
namespace {

Camera small_camera() {
  Camera camera;
  camera.name = "small";
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 300.0;
  camera.cx = 79.5;
  camera.cy = 59.5;
  camera.distortion = {-0.15, 0.02, 1e-3, -1e-3};
  camera.camera_from_world.translation = {0.0, 0.0, 0.75};
  return camera;
}

TriangleMesh ball(double radius, const Eigen::Vector3d& center) {
  TriangleMesh mesh =
      object_surface({HeldObject::Shape::sphere, Eigen::Vector3d::Constant(radius)}, 0.003);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex += center;
  return mesh;
}

// A warm ball in the middle; a cold one in front of its right edge or behind it.
RoomScene scene_with_cold_at(double depth) {
  RoomScene scene;
  scene.warm.mesh = ball(0.05, Eigen::Vector3d::Zero());
  scene.warm.radiance.assign(scene.warm.mesh.vertices.size(), 0.7f);
  scene.cold = ball(0.03, {0.05, 0.0, depth});
  return scene;
}

double mean_around(const CameraImage& picture, const Eigen::Vector2d& pixel) {
  double sum = 0.0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      sum += picture.values(static_cast<int>(pixel.x()) + x, static_cast<int>(pixel.y()) + y);
    }
  }
  return sum / 25.0;
}

TEST(InfraredCamera, ColdObjectIsAsDarkAsTheRoomAndHidesWhatIsBehindIt) {
  const Camera camera = small_camera();
  const Eigen::Vector2d shared = *project(camera, {0.035, 0.0, 0.0});
  const Eigen::Vector2d beside = *project(camera, {0.065, 0.0, 0.0});
  const Eigen::Vector2d empty = *project(camera, {0.0, -0.09, 0.0});
  const CameraImage hides = infrared_picture(scene_with_cold_at(-0.1), camera, {});
  const CameraImage behind = infrared_picture(scene_with_cold_at(0.1), camera, {});
  EXPECT_LT(mean_around(hides, shared), 0.38 * 255);
  EXPECT_GT(mean_around(behind, shared), 0.55 * 255);
  EXPECT_NEAR(mean_around(hides, beside), mean_around(hides, empty), 0.10 * 255);
}

TEST(InfraredCamera, EdgesAreWhereTheMaskHasThem) {
  const Camera camera = small_camera();
  RoomScene scene = scene_with_cold_at(0.0);
  scene.cold = {};
  const CameraImage picture = infrared_picture(scene, camera, {});
  const Silhouette mask = room_mask(scene, camera);
  std::size_t different = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const bool warm = picture.values(x, y) > 0.47 * 255;
      if (warm != (mask(x, y) == PixelLabel::hand)) ++different;
    }
  }
  // The border is 126 pixels long; half of one pixel's shift would change more than 40.
  EXPECT_LT(different, 25u);
  EXPECT_NEAR(static_cast<double>(count_pixels(mask, PixelLabel::hand)), 1260.0, 60.0);
}

TEST(InfraredCamera, SixteenBitsAreRawCountsInANarrowRange) {
  const CameraImage picture =
      infrared_picture(scene_with_cold_at(-0.1), small_camera(), {.bits = 16});
  EXPECT_EQ(picture.bits, 16);
  const auto [least, most] =
      std::minmax_element(picture.values.values().begin(), picture.values.values().end());
  EXPECT_GT(*least, 7200);
  EXPECT_GT(*most, 8500);
  EXPECT_LT(*most, 9200);
}

TEST(InfraredCamera, NoiseDiffersFromPictureToPictureButTheRoomStays) {
  const Camera camera = small_camera();
  const RoomScene scene = scene_with_cold_at(0.1);
  const CameraImage a = infrared_picture(scene, camera, {.room_seed = 1, .noise_seed = 1});
  const CameraImage same = infrared_picture(scene, camera, {.room_seed = 1, .noise_seed = 1});
  const CameraImage b = infrared_picture(scene, camera, {.room_seed = 1, .noise_seed = 2});
  EXPECT_EQ(a.values, same.values);
  EXPECT_NE(a.values, b.values);
  double squares = 0.0;
  for (std::size_t i = 0; i < a.values.values().size(); ++i) {
    const double off = static_cast<double>(a.values.values()[i]) - b.values.values()[i];
    squares += off * off / static_cast<double>(a.values.values().size());
  }
  EXPECT_NEAR(std::sqrt(squares / 2.0) / 255.0, 0.01, 0.001);
}

TEST(InfraredCamera, MaskIsUnknownOnlyWhereTheObjectIsNearest) {
  const Camera camera = small_camera();
  const auto label_at = [&](const Silhouette& mask, const Eigen::Vector3d& point) {
    const Eigen::Vector2d pixel = *project(camera, point);
    return mask(static_cast<int>(pixel.x() + 0.5), static_cast<int>(pixel.y() + 0.5));
  };
  const Silhouette hides = room_mask(scene_with_cold_at(-0.1), camera);
  EXPECT_EQ(label_at(hides, {0.035, 0.0, 0.0}), PixelLabel::unknown);
  EXPECT_EQ(label_at(hides, {-0.03, 0.0, 0.0}), PixelLabel::hand);
  EXPECT_EQ(label_at(hides, {0.0, -0.09, 0.0}), PixelLabel::background);
  const Silhouette behind = room_mask(scene_with_cold_at(0.1), camera);
  EXPECT_EQ(label_at(behind, {0.035, 0.0, 0.0}), PixelLabel::hand);
  EXPECT_GT(count_pixels(behind, PixelLabel::unknown), 50u);  // what looks out from behind
}

TEST(InfraredCamera, EmptySceneAndOddBitsAreHandled) {
  EXPECT_EQ(infrared_picture({}, small_camera(), {}).values.width(), 160);
  EXPECT_EQ(count_pixels(room_mask({}, small_camera()), PixelLabel::background), 160u * 120u);
  EXPECT_THROW(infrared_picture({}, small_camera(), {.bits = 12}), Error);
}

}  // namespace
}  // namespace tegata
