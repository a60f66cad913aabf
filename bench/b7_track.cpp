// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks.h"
#include "report.h"
#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/hand_tracker.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/image/rasterizer.h"
#include "tegata/sim/grasps.h"
#include "tegata/sim/hand_motion.h"
#include "tegata/sim/room_cameras.h"

namespace tegata::bench {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kFrames = 61;
constexpr double kTurnDeg = 3.0;      // a frame: 90 degrees a second
constexpr double kVoxelSize = 0.002;  // [m]
constexpr int kRounds = 3;
constexpr double kToHold = 30.0;             // frames a second
constexpr double kMostKeypointError = 1e-3;  // mean over all keypoints and frames [m]

// Silhouettes of a grasping hand that turns, with nothing before it.
struct Stream {
  explicit Stream(int camera_count)
      : model(built_in_hand({}, Side::right)),
        hand(model),
        angles(make_grasp(model, SimulatedGrasp::cylinder, kSeed).angles) {
    constexpr double kZoom = 0.82;  // for about 10,000 pixels a view
    const Eigen::Vector3d center = bounding_box(PosedHand(model, {{}, angles}).surface()).center();
    poses = hand_motion(center, {.frame_count = kFrames, .turn_deg = kTurnDeg, .seed = kSeed});
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

  HandModel model;
  FitHand hand;
  JointAngles angles;
  std::vector<Rigid3d> poses;
  std::vector<std::vector<HullView>> frames;
};

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

struct Tracking {
  double frames_per_second = 0.0;
  double keypoint_error = 0.0;  // mean [m]
};

// The stream once through: each frame is prepared while the one before it is followed.
Tracking track(const Stream& stream, bool with_hull, int threads) {
  HandTracker tracker(stream.hand, {.threads = threads});
  tracker.next(prepared(stream.frames.front(), true, threads));
  Tracking tracking;
  const Stopwatch watch;
  FitFrame current = prepared(stream.frames[1], with_hull, threads);
  for (std::size_t f = 1; f < stream.frames.size(); ++f) {
    FitFrame next;
    TrackedFrame tracked;
    parallel_for(2, threads, [&](std::size_t job) {
      if (job == 0) tracked = tracker.next(current);
      if (job == 1 && f + 1 < stream.frames.size()) {
        next = prepared(stream.frames[f + 1], with_hull, threads);
      }
    });
    current = std::move(next);
    if (tracked.state != TrackState::followed) throw Error("b7: the hand is lost in frame ", f);
    const auto found = posed_keypoints(stream.model.skeleton, tracked.pose);
    const auto truth = posed_keypoints(stream.model.skeleton, {stream.poses[f], stream.angles});
    for (std::size_t k = 0; k < found.size(); ++k) {
      tracking.keypoint_error += (found[k] - truth[k]).norm();
    }
  }
  const double count = static_cast<double>(stream.frames.size() - 1);
  tracking.frames_per_second = count / watch.seconds();
  tracking.keypoint_error /= count * static_cast<double>(kKeypointCount);
  return tracking;
}

}  // namespace

bool benchmark_track() {
  Report report("B7: silhouettes in memory to joint angles, tracked, 640 x 480 pixels");
  for (const int cameras : {3, 8}) {
    const Stream stream(cameras);
    for (const bool with_hull : {false, true}) {
      const std::string work =
          fmt::format("{} cameras{}", cameras, with_hull ? ", with 2 mm hulls" : "");
      for (const int threads : {1, 2}) {
        Tracking best;
        for (int round = 0; round < kRounds; ++round) {
          const Tracking now = track(stream, with_hull, threads);
          if (now.frames_per_second > best.frames_per_second) best = now;
        }
        const double rate = best.frames_per_second;
        report.note(fmt::format(
            "{}, {} thread{}: {:.1f} frames/s by the clock{}", work, threads,
            threads == 1 ? "" : "s", rate,
            cameras == 3 && threads == 2
                ? fmt::format(" ({:g} to hold: {})", kToHold, rate >= kToHold ? "held" : "not held")
                : ""));
        if (threads == 2) {
          report.check(fmt::format("{}: mean keypoint error, at most 1 mm", work),
                       fmt::format("{:.3f} mm", 1e3 * best.keypoint_error),
                       best.keypoint_error <= kMostKeypointError);
        }
      }
    }
  }
  return report.print();
}

}  // namespace tegata::bench
