// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/lost_frames.h"

#include <algorithm>
#include <memory>

#include "tegata/base/parallel.h"
#include "tegata/fit/contradiction.h"
#include "tegata/fit/known_grasp.h"
#include "tegata/fit/support.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// Beyond so many times what is usual, uncovered [m] of a hand of FitHand::scale 1.
constexpr double kLostUncovered = 1e-4, kLostRatio = 3.0;

class LostFrames {
 public:
  LostFrames(const FitHand& hand, const FrameSource& frames, const KnownGrasp& grasp, int threads,
             std::vector<HandPose>& poses, std::vector<std::vector<std::string>>& left_out)
      : hand_(hand),
        frames_(frames),
        grasp_(grasp),
        poses_(poses),
        left_out_(left_out),
        uncovered_(frames.size()) {
    parallel_for(frames.size(), threads, [&](std::size_t f) {
      uncovered_[f] = uncovered_in_most(hand, *frames.frame(f), poses[f]);
    });
    most_uncovered_ = most_uncovered(hand, uncovered_);
  }

  // From the neighbour before where the step is -1, from the one behind where it is 1.
  void seek(std::size_t f, int step) {
    const std::size_t next = f + static_cast<std::size_t>(step);
    const std::size_t next_but_one = next + static_cast<std::size_t>(step);
    if (is_found(f) || !is_found(next)) return;
    Rigid3d expected = poses_[next].world_from_hand;
    if (is_found(next_but_one)) {
      expected = extrapolated(poses_[next_but_one].world_from_hand, expected);
    }
    const std::shared_ptr<const FitFrame> frame = frames_.frame(f);
    HandPose pose = fit_known_from_afar(hand_, *frame, {expected, grasp_.angles}, grasp_.object,
                                        grasp_.schedule)
                        .pose;
    pose.angles = grasp_.angles;
    const std::vector<double> left = uncovered_distances(hand_, *frame, pose);
    // A view that was left out may have been right: the hand was elsewhere.
    const bool agrees_with_all = *std::max_element(left.begin(), left.end()) <= most_uncovered_;
    const double uncovered = uncovered_in_most(hand_, *frame, pose);
    if (!agrees_with_all && (!left_out_[f].empty() || uncovered >= uncovered_[f])) return;
    poses_[f] = pose;
    left_out_[f].clear();
    uncovered_[f] = uncovered;
  }

 private:
  bool is_found(std::size_t f) const {
    return f < frames_.size() && uncovered_[f] <= most_uncovered_;
  }

  const FitHand& hand_;
  const FrameSource& frames_;
  const KnownGrasp& grasp_;
  std::vector<HandPose>& poses_;
  std::vector<std::vector<std::string>>& left_out_;
  std::vector<double> uncovered_;  // of each frame [m]
  double most_uncovered_ = 0.0;
};

}  // namespace

double uncovered_in_most(const FitHand& hand, const FitFrame& frame, const HandPose& pose) {
  if (frame.views.empty()) return 0.0;
  const PosedHand posed = hand.posed(pose);
  std::vector<double> distances = uncovered_distances(hand, frame, pose);
  for (std::size_t v = 0; v < distances.size(); ++v) {
    if (silhouette_overlap(hand, posed, frame.views[v]) < kLeastSeenOverlap) {
      distances[v] = kWhollyUncovered * hand.scale;
    }
  }
  return median(std::move(distances));
}

double most_uncovered(const FitHand& hand, const std::vector<double>& uncovered) {
  return kLostUncovered * hand.scale + kLostRatio * median(uncovered);
}

void find_lost_frames(const FitHand& hand, const FrameSource& frames, const KnownGrasp& grasp,
                      int threads, std::vector<HandPose>& poses,
                      std::vector<std::vector<std::string>>& left_out) {
  LostFrames lost(hand, frames, grasp, threads, poses, left_out);
  for (std::size_t f = 1; f < frames.size(); ++f) lost.seek(f, -1);
  for (std::size_t f = frames.size(); f-- > 0;) lost.seek(f, 1);
}

}  // namespace tegata
