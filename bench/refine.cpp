// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "benchmarks.h"
#include "hand_stream.h"
#include "report.h"
#include "tegata/base/random.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/frame_fit.h"
#include "tegata/math/so3.h"

namespace tegata::bench {
namespace {

constexpr int kCameras = 3, kFrames = 30, kThreads = 2, kRounds = 3;
constexpr double kToHold = 2.0;              // [s]
constexpr double kMostKeypointError = 1e-3;  // mean over all keypoints and frames [m]

// About what single frames leave: each pose and each angle off by normal deviates.
HandEstimate disturbed(const HandStream& stream) {
  constexpr double kTurn = 0.08, kShift = 0.005, kBend = 0.1;  // [rad], [m], [rad]
  Random random(1);
  const auto some_way = [&] {
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  };
  HandEstimate estimate{stream.angles, {}};
  for (double& angle : estimate.angles) angle += kBend * random.normal();
  for (const Rigid3d& pose : stream.poses) {
    estimate.world_from_hand.push_back(
        {so3_exp(kTurn * some_way()) * pose.rotation, pose.translation + kShift * some_way()});
  }
  return estimate;
}

double mean_error(const HandStream& stream, const HandEstimate& estimate) {
  double sum = 0.0;
  for (std::size_t f = 0; f < stream.poses.size(); ++f) {
    sum += stream.keypoint_error(f, estimate.pose(f));
  }
  return sum / static_cast<double>(stream.poses.size());
}

}  // namespace

bool benchmark_refine() {
  Report report("Joint estimation: 30 frames of 3 cameras, one set of angles, 640 x 480 pixels");
  const HandStream stream(kCameras, kFrames);
  std::vector<FitFrame> frames;
  for (const auto& views : stream.frames) frames.push_back(prepared(views, true, kThreads));
  std::vector<const FitFrame*> pointers;
  for (const FitFrame& frame : frames) pointers.push_back(&frame);
  const HandEstimate start = disturbed(stream);
  HandEstimate found;
  double seconds = std::numeric_limits<double>::infinity();
  int iterations = 0;
  for (int round = 0; round < kRounds; ++round) {
    found = start;
    const Stopwatch watch;
    iterations = minimise(stream.hand, pointers, grasp_schedule(), kThreads, found).iterations;
    seconds = std::min(seconds, watch.seconds());
  }
  report.note(fmt::format("{} iterations on {} threads: {:.2f} s by the clock ({:g} to hold: {})",
                          iterations, kThreads, seconds, kToHold,
                          seconds <= kToHold ? "held" : "not held"));
  const double before = mean_error(stream, start), after = mean_error(stream, found);
  report.check("mean keypoint error, at most 1 mm",
               fmt::format("{:.2f} mm, before {:.1f}", 1e3 * after, 1e3 * before),
               after <= kMostKeypointError);
  return report.print();
}

}  // namespace tegata::bench
