// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <bit>
#include <string>
#include <utility>

#include "benchmarks.h"
#include "chain_tracker.h"
#include "hand_stream.h"
#include "report.h"
#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/fit/hand_tracker.h"

namespace tegata::bench {
namespace {

constexpr int kFrames = 61;
constexpr int kRounds = 5;
constexpr double kRateToHold = 30.0;           // frames a second of three cameras on two cores
constexpr double kToHold = 3.0, kThen = 10.0;  // the best chain's time over ours
constexpr double kMostKeypointError = 1e-3;    // mean over all keypoints and frames [m]

// A tracker that has found the hand in the first frame.
HandTracker tracker_of(const HandStream& stream, int threads) {
  HandTracker tracker(stream.hand, {.threads = threads});
  tracker.next(prepared(stream.frames.front(), true, threads));
  return tracker;
}

// The rest of the stream: each frame is prepared while the one before it is followed. The mean
// keypoint error [m].
double track(const HandStream& stream, HandTracker tracker, bool with_hull, int threads) {
  double error = 0.0;
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
    error += stream.keypoint_error(f, tracked.pose);
  }
  return error / static_cast<double>(stream.frames.size() - 1);
}

// Ours and the chains with so many threads, in turns; how far off ours and theirs are.
void compare(const HandStream& stream, int cameras, int threads, Report& report) {
  const HandTracker tracker = tracker_of(stream, threads);
  double ours = 0.0, ours_with_hulls = 0.0;
  ChainTracker simplified(stream, true), sampled(stream, false);
  ChainTracker::Run simplified_run, sampled_run;
  const std::vector<Contestant> contestants = {
      {"tegata HandTracker",
       [&] {
         ours = track(stream, tracker, false, threads);
         return std::bit_cast<std::size_t>(ours);
       }},
      {"tegata HandTracker, with 2 mm hulls",
       [&] {
         ours_with_hulls = track(stream, tracker, true, threads);
         return std::bit_cast<std::size_t>(ours_with_hulls);
       }},
      {"chain, hull simplified to 4,000",
       [&] {
         simplified_run = simplified.run(threads);
         return std::bit_cast<std::size_t>(simplified_run.keypoint_error);
       },
       kToHold},
      {"chain, 2,000 of the hull's vertices",
       [&] {
         sampled_run = sampled.run(threads);
         return std::bit_cast<std::size_t>(sampled_run.keypoint_error);
       },
       kToHold}};
  const std::string work =
      fmt::format("{} cameras, {} thread{}", cameras, threads, threads == 1 ? "" : "s");
  std::vector<Timing> timings =
      run_rounds(contestants, threads == 1 ? Clock::processor : Clock::wall, kRounds);
  for (Timing& timing : timings) timing.milliseconds /= kFrames - 1;
  report.add(work, contestants, timings);
  const double rate = 1e3 / timings[0].milliseconds;
  report.note(fmt::format(
      "{}: {:.1f} frames/s, with hulls {:.1f}{}", work, rate, 1e3 / timings[1].milliseconds,
      cameras == 3 && threads == 2 ? fmt::format(" ({:g} to hold: {})", kRateToHold,
                                                 rate >= kRateToHold ? "held" : "not held")
                                   : ""));
  for (const auto& [name, run] : {std::pair{contestants[2].name, simplified_run},
                                  std::pair{contestants[3].name, sampled_run}}) {
    report.note(fmt::format(
        "{}: {}: mean keypoint error {:.2f} mm, {:.1f} rounds a frame; hull {:.1f} ms, rounds "
        "{:.1f} ms",
        work, name, 1e3 * run.keypoint_error, run.rounds, 1e3 * run.hull_seconds,
        1e3 * run.fit_seconds));
  }
  for (const auto& [name, error] :
       {std::pair{"", ours}, std::pair{", with hulls", ours_with_hulls}}) {
    report.check(fmt::format("{}{}: mean keypoint error, at most 1 mm", work, name),
                 fmt::format("{:.3f} mm", 1e3 * error), error <= kMostKeypointError);
  }
}

}  // namespace

bool benchmark_track() {
  Report report("B7: silhouettes in memory to joint angles, tracked, 640 x 480 pixels");
  for (const int cameras : {3, 8}) {
    const HandStream stream(cameras, kFrames);
    for (const int threads : {1, 2}) compare(stream, cameras, threads, report);
  }
  report.note(
      fmt::format("once {:g} is held against the faster chain, {:g} is to hold", kToHold, kThen));
  return report.print();
}

}  // namespace tegata::bench
