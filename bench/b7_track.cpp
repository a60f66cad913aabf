// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "benchmarks.h"
#include "hand_stream.h"
#include "report.h"
#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/hand_tracker.h"

namespace tegata::bench {
namespace {

constexpr int kFrames = 61;
constexpr int kRounds = 3;
constexpr double kToHold = 30.0;             // frames a second
constexpr double kMostKeypointError = 1e-3;  // mean over all keypoints and frames [m]

struct Tracking {
  double frames_per_second = 0.0;
  double keypoint_error = 0.0;  // mean [m]
};

// The stream once through: each frame is prepared while the one before it is followed.
Tracking track(const HandStream& stream, bool with_hull, int threads) {
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
    tracking.keypoint_error += stream.keypoint_error(f, tracked.pose);
  }
  const double count = static_cast<double>(stream.frames.size() - 1);
  tracking.frames_per_second = count / watch.seconds();
  tracking.keypoint_error /= count;
  return tracking;
}

}  // namespace

bool benchmark_track() {
  Report report("B7: silhouettes in memory to joint angles, tracked, 640 x 480 pixels");
  for (const int cameras : {3, 8}) {
    const HandStream stream(cameras, kFrames);
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
