// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/contradiction.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/fit/known_grasp.h"
#include "tegata/fit/support.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

constexpr std::size_t kLeastViews = 3;

// How much of a seen hand lies uncovered on average, beyond what is usual [m]: a frame is looked at
// where one view has more than the first, a view contradicts the others where it has more than the
// second and they are left with less than the third.
constexpr double kSuspicious = 2e-4, kContradictory = 3e-4, kAgreeing = 1e-4;
constexpr double kSuspiciousRatio = 3.0, kAgreeingRatio = 1.5;
// Or with less than this part of what is uncovered in the view that contradicts them.
constexpr double kAgreeingShare = 0.1;

FitFrame without_view(const FitFrame& frame, std::size_t view) {
  FitFrame others = frame;
  others.views.erase(others.views.begin() + static_cast<std::ptrdiff_t>(view));
  return others;
}

FitFrame without_view(const FitFrame& frame, std::size_t view, const HullOptions& hull) {
  FitFrame others = without_view(frame, view);
  std::vector<HullView> views;
  for (const FitView& other : others.views) views.push_back({other.camera, other.silhouette});
  try {
    others.hull.emplace(visual_hull(views, hull));
  } catch (const Error&) {
    others.hull.reset();
  }
  return others;
}

/// A frame's views but one, and the hand by them.
struct Hypothesis {
  std::optional<double> without;  // uncovered in the view that was left out
  double others = 0.0;            // and in the others, on average
  HandPose pose;
};

// Where a frame's views, or those that are left of them, have the hand.
HandPose known_pose(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                    const TriangleMesh& object, const FitSchedule& schedule) {
  HandPose pose = fit_known_from_afar(hand, frame, start, object, schedule).pose;
  // The angles were free to move a little; the pose alone is of the frame.
  pose.angles = start.angles;
  return pose;
}

double mean_without(const std::vector<double>& distances, std::size_t view) {
  const double all = std::accumulate(distances.begin(), distances.end(), 0.0);
  return (all - distances[view]) / static_cast<double>(distances.size() - 1);
}

Hypothesis leave_out(const FitHand& hand, const FitFrame& frame, std::size_t view,
                     const HandPose& start, const TriangleMesh& object,
                     const FitSchedule& schedule) {
  const HandPose pose = known_pose(hand, without_view(frame, view), start, object, schedule);
  return {uncovered_distance(hand, hand.posed(pose), frame.views[view]),
          mean_without(uncovered_distances(hand, frame, pose), view), pose};
}

}  // namespace

std::vector<double> uncovered_distances(const FitHand& hand, const FitFrame& frame,
                                        const HandPose& pose) {
  const PosedHand posed = hand.posed(pose);
  std::vector<double> distances;
  for (const FitView& view : frame.views) {
    distances.push_back(uncovered_distance(hand, posed, view).value_or(0.0));
  }
  return distances;
}

std::vector<Contradiction> find_contradictions(const FitHand& hand,
                                               std::span<const FitFrame* const> frames,
                                               const std::vector<HandPose>& poses,
                                               const TriangleMesh& object,
                                               const ContradictionOptions& options, int threads) {
  std::vector<std::vector<double>> left(frames.size());
  parallel_for(frames.size(), threads,
               [&](std::size_t f) { left[f] = uncovered_distances(hand, *frames[f], poses[f]); });
  std::vector<double> all;
  for (const std::vector<double>& distances : left)
    all.insert(all.end(), distances.begin(), distances.end());
  const double usual = all.empty() ? 0.0 : median(all);
  const double suspicious = kSuspicious * hand.scale + kSuspiciousRatio * usual;
  const double contradictory = kContradictory * hand.scale + kSuspiciousRatio * usual;
  const double agreeing = kAgreeing * hand.scale + kAgreeingRatio * usual;

  std::vector<std::optional<Contradiction>> found(frames.size());
  parallel_for(frames.size(), threads, [&](std::size_t f) {
    const std::size_t count = frames[f]->views.size();
    if (count < kLeastViews || *std::max_element(left[f].begin(), left[f].end()) < suspicious) {
      return;
    }
    std::optional<Hypothesis> best;
    for (std::size_t v = 0; v < count; ++v) {
      const Hypothesis now = leave_out(hand, *frames[f], v, poses[f], object, options.schedule);
      if (best && now.others >= best->others) continue;
      best = now;
      found[f] = {f, v, now.pose};
    }
    // A view along the forearm cannot tell what it leaves uncovered.
    const bool agree_alone =
        best->others <= std::max(agreeing, kAgreeingShare * best->without.value_or(0.0));
    if (agree_alone && best->without.value_or(contradictory) >= contradictory) {
      // Unless all agree once the hand is sought from where the others have it.
      const HandPose drawn = known_pose(hand, *frames[f], best->pose, object, options.schedule);
      const std::vector<double> all_left = uncovered_distances(hand, *frames[f], drawn);
      if (*std::max_element(all_left.begin(), all_left.end()) > suspicious) return;
    }
    found[f].reset();
  });
  std::vector<Contradiction> contradictions;
  for (const std::optional<Contradiction>& one : found) {
    if (one) contradictions.push_back(*one);
  }
  return contradictions;
}

AgreeingFrames::AgreeingFrames(std::span<const FitFrame* const> frames)
    : frames_(frames.begin(), frames.end()), mended_(frames.size()), left_out_(frames.size()) {}

bool AgreeingFrames::leave_out_contradictions(const FitHand& hand, std::vector<HandPose>& poses,
                                              const TriangleMesh& object,
                                              const ContradictionOptions& options, int threads) {
  const std::vector<Contradiction> found =
      find_contradictions(hand, frames_, poses, object, options, threads);
  for (const auto& [f, view, pose] : found) {
    left_out_[f].push_back(frames_[f]->views[view].camera.name);
    mended_[f] = std::make_unique<const FitFrame>(without_view(*frames_[f], view, options.hull));
    frames_[f] = mended_[f].get();
    poses[f] = pose;
  }
  return !found.empty();
}

}  // namespace tegata
