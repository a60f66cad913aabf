// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <vector>

#include "benchmarks.h"
#include "report.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/pipeline/silhouettes.h"
#include "tegata/sim/virtual_room.h"
#include "tegata/take/picture_file.h"

namespace tegata::bench {
namespace {

constexpr std::size_t kFrames = 8;
constexpr double kLeastOverlap = 0.99;  // with the mask that a perfect segmentation gives
constexpr double kToHold = 100.0;       // frames a second of three streams on two cores
constexpr int kRounds = 7;

// A take of the virtual room in a folder that goes away with it.
class SimulatedTake {
 public:
  explicit SimulatedTake(SimulatedMode mode)
      : folder_(std::filesystem::temp_directory_path() /
                fmt::format("tegata_bench_{}", simulated_mode_name(mode))) {
    SimulationOptions options;
    options.mode = mode;
    options.bits = 16;
    options.frame_count = static_cast<int>(kFrames);
    simulate_take(built_in_hand({}, Side::right), options, folder_, true, {});
    Take take = Take::open(folder_);
    for (std::size_t i = 0; i < kFrames; ++i) frames_.push_back(take.read_frame(i, {}));
  }
  ~SimulatedTake() { std::filesystem::remove_all(folder_); }
  SimulatedTake(const SimulatedTake&) = delete;
  SimulatedTake& operator=(const SimulatedTake&) = delete;

  const std::vector<TakeFrame>& frames() const { return frames_; }
  Segmenter segmenter() const {
    Take take = Take::open(folder_);
    return Segmenter(take, {}, {});
  }

 private:
  std::filesystem::path folder_;
  std::vector<TakeFrame> frames_;
};

// Seconds for all frames, each on one thread.
struct Seconds {
  double clock = 1e9;
  double processor = 1e9;  // of all threads
};

// The least of some rounds.
Seconds fastest_round(const Segmenter& segmenter, const std::vector<TakeFrame>& frames,
                      int threads) {
  Seconds fastest;
  for (int round = 0; round < kRounds; ++round) {
    const Stopwatch watch;
    const std::clock_t start = std::clock();
    parallel_for(frames.size(), threads, [&](std::size_t i) {
      const auto silhouettes = segmenter.segment(frames[i]);
      for (std::size_t c = 0; c < silhouettes.size(); ++c) {
        segmenter.undistorted(*silhouettes[c], c);
      }
    });
    fastest.clock = std::min(fastest.clock, watch.seconds());
    fastest.processor = std::min(
        fastest.processor, static_cast<double>(std::clock() - start) / double{CLOCKS_PER_SEC});
  }
  return fastest;
}

double least_overlap(const Segmenter& segmenter, const std::vector<TakeFrame>& frames,
                     const std::vector<TakeFrame>& masks) {
  double least = 1.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto silhouettes = segmenter.segment(frames[i]);
    for (std::size_t c = 0; c < silhouettes.size(); ++c) {
      const Silhouette truth = silhouette_from_mask(*masks[i].pictures[c]);
      least = std::min(least, intersection_over_union(*silhouettes[c], truth));
    }
  }
  return least;
}

}  // namespace

bool benchmark_segmentation() {
  const SimulatedTake infrared(SimulatedMode::infrared), masks(SimulatedMode::mask);
  const Segmenter segmenter = infrared.segmenter();
  Report report("Segmentation: 3 infrared streams of 640 x 480 pixels and 16 bits, in memory");
  for (const int threads : {1, 2}) {
    const Seconds seconds = fastest_round(segmenter, infrared.frames(), threads);
    const double rate = static_cast<double>(kFrames) / seconds.clock;
    report.note(fmt::format(
        "{} thread{}: {:.0f} frames/s segmented and undistorted by the clock, {:.2f} ms of "
        "processor time a picture{}",
        threads, threads == 1 ? "" : "s", rate, 1e3 * seconds.processor / (3.0 * kFrames),
        threads == 1
            ? ""
            : fmt::format(" ({:g} to hold: {})", kToHold, rate >= kToHold ? "held" : "not held")));
  }
  const double least = least_overlap(segmenter, infrared.frames(), masks.frames());
  report.check("least overlap with the true mask, at least 0.99", fmt::format("{:.4f}", least),
               least >= kLeastOverlap);
  return report.print();
}

}  // namespace tegata::bench
