// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include "tegata/hand/built_in_hand.h"
#include "tegata/image/rasterizer.h"
#include "tegata/sim/grasps.h"
#include "tegata/sim/hand_motion.h"
#include "tegata/sim/held_object.h"
#include "tegata/sim/room_cameras.h"

namespace tegata::bench {
namespace {

constexpr std::uint64_t kSeed = 1;

CameraRig ideal_cameras(int count) {
  return room_cameras(
      {.count = count, .width = 640, .height = 480, .distortion = false, .seed = kSeed});
}

// Lenses shorter by `zoom` than in the room.
void look(Scene& scene, int camera_count, double zoom) {
  for (Camera& camera : ideal_cameras(camera_count)) {
    camera.fx *= zoom;
    camera.fy *= zoom;
    scene.views.push_back({camera, render_silhouette(scene.surface, camera)});
  }
}

}  // namespace

std::size_t Scene::mean_foreground() const {
  std::size_t sum = 0;
  for (const HullView& view : views) sum += count_pixels(view.silhouette, PixelLabel::hand);
  return sum / views.size();
}

Scene hand_scene(int camera_count) {
  constexpr double kZoom = 0.82;  // for about 10,000 pixels a view
  const HandModel hand = built_in_hand({}, Side::right);
  const Grasp grasp = make_grasp(hand, SimulatedGrasp::cylinder, kSeed);
  const Eigen::Vector3d center =
      bounding_box(PosedHand(hand, {{}, grasp.angles}).surface()).center();
  const auto motion = hand_motion(center, {.frame_count = 1, .seed = kSeed});
  Scene scene;
  scene.surface = PosedHand(hand, {motion.front(), grasp.angles}).surface();
  look(scene, camera_count, kZoom);
  return scene;
}

Scene ball_scene(int camera_count) {
  constexpr double kRadius = 0.2, kLongestEdge = 0.005;  // [m]
  constexpr double kZoom = 0.4;                          // for all of it to be in the picture
  Scene scene;
  scene.surface =
      object_surface({HeldObject::Shape::sphere, Eigen::Vector3d::Constant(kRadius)}, kLongestEdge);
  look(scene, camera_count, kZoom);
  return scene;
}

Eigen::AlignedBox3d region_of_cells(const Eigen::Vector3d& center, int cells, double cell_size) {
  // The octree's cube is at least one cell wider on every side.
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(0.5 * (cells - 2.5) * cell_size);
  return {center - reach, center + reach};
}

HullOptions hull_options(const Scene& scene, double voxel_size) {
  return {.voxel_size = voxel_size, .least_views = static_cast<int>(scene.views.size()) / 2 + 1};
}

}  // namespace tegata::bench
