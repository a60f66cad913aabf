// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "hand_stream.h"

#include <optional>

#include "tegata/base/parallel.h"
#include "tegata/image/rasterizer.h"
#include "tegata/sim/grasps.h"
#include "tegata/sim/hand_motion.h"
#include "tegata/sim/room_cameras.h"

namespace tegata::bench {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr double kTurnDeg = 3.0;      // a frame: 90 degrees a second
constexpr double kVoxelSize = 0.002;  // [m]

}  // namespace

HandStream::HandStream(int camera_count, int frame_count)
    : model(built_in_hand({}, Side::right)),
      hand(model),
      angles(make_grasp(model, SimulatedGrasp::cylinder, kSeed).angles) {
  constexpr double kZoom = 0.82;  // for about 10,000 pixels a view
  const Eigen::Vector3d center = bounding_box(PosedHand(model, {{}, angles}).surface()).center();
  poses = hand_motion(center, {.frame_count = frame_count, .turn_deg = kTurnDeg, .seed = kSeed});
  const CameraRig cameras = room_cameras(
      {.count = camera_count, .width = 640, .height = 480, .distortion = false, .seed = kSeed});
  for (const Rigid3d& pose : poses) {
    const TriangleMesh surface = PosedHand(model, {pose, angles}).surface();
    std::vector<HullView>& views = frames.emplace_back();
    for (Camera camera : cameras) {
      camera.fx *= kZoom;
      camera.fy *= kZoom;
      views.push_back({camera, render_silhouette(surface, camera)});
    }
  }
}

double HandStream::keypoint_error(std::size_t frame, const HandPose& found) const {
  const auto there = posed_keypoints(model.skeleton, found);
  const auto truth = posed_keypoints(model.skeleton, {poses[frame], angles});
  double sum = 0.0;
  for (std::size_t k = 0; k < there.size(); ++k) sum += (there[k] - truth[k]).norm();
  return sum / static_cast<double>(there.size());
}

FitFrame prepared(const std::vector<HullView>& views, bool with_hull, int threads) {
  std::vector<std::optional<FitView>> made(views.size());
  FitFrame frame;
  parallel_for(views.size() + (with_hull ? 1 : 0), threads, [&](std::size_t i) {
    // The longest first.
    if (with_hull && i == 0) {
      const int least_views = static_cast<int>(views.size()) / 2 + 1;
      frame.hull.emplace(
          visual_hull(views, {.voxel_size = kVoxelSize, .least_views = least_views}));
      return;
    }
    const std::size_t v = i - (with_hull ? 1 : 0);
    made[v] = make_fit_view(views[v].camera, views[v].silhouette);
  });
  for (auto& view : made) frame.views.push_back(std::move(*view));
  return frame;
}

}  // namespace tegata::bench
