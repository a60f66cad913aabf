// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/hand_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tegata/fit/known_grasp.h"
#include "tegata/fit/start.h"
#include "tegata/fit/support.h"
#include "tegata/math/median.h"

namespace tegata {
namespace {

// An energy that is so many times the usual one is not that of the hand, in a picture of the same
// kind as before; so many frames tell what is usual.
constexpr double kLostEnergyRatio = 3.0;
constexpr std::size_t kEnergiesKept = 30, kEnergiesNeeded = 3;
// With an energy of so many times the usual one the hand is where it was expected.
constexpr double kNearEnergyRatio = 1.5;
// Less of the silhouettes than this is no hand: what is held eats up to half of one in infrared.
constexpr double kLeastOverlap = 0.4;
// Angles are never known better than this [rad]: the frames of a stream are much alike.
constexpr double kLeastDeviation = 0.01;
// After a hand was lost its grasp may be another one.
constexpr double kDeviationsOnceLost[] = {0.3, 0.3, 0.3, 0.3};

}  // namespace

HandTracker::HandTracker(const FitHand& hand, const TrackOptions& options)
    : hand_(hand), options_(options) {}

FitSchedule HandTracker::with_known_angles() const {
  FitSchedule schedule = options_.follow;
  for (FitStage& stage : schedule.stages) {
    stage.prior.previous = angles_;
    stage.prior.previous_standard_deviations =
        (deviations_.array().square() + options_.drift * options_.drift).sqrt();
  }
  return schedule;
}

double HandTracker::usual_energy() const {
  if (energies_.size() < kEnergiesNeeded) return std::numeric_limits<double>::infinity();
  return median(std::vector<double>(energies_.begin(), energies_.end()));
}

bool HandTracker::is_hand(const FitFrame& frame, const FrameFit& fit) const {
  const PosedHand posed = hand_.posed(fit.pose);
  double sum = 0.0;
  for (const FitView& view : frame.views) sum += silhouette_overlap(hand_, posed, view);
  if (sum < kLeastOverlap * static_cast<double>(frame.views.size())) return false;
  return fit.report.energy <= kLostEnergyRatio * usual_energy();
}

std::optional<FrameFit> HandTracker::follow(const FitFrame& frame) const {
  const Rigid3d expected = last_but_one_ ? extrapolated(*last_but_one_, *last_) : *last_;
  const FitSchedule schedule = with_known_angles();
  const auto fit_by = [&](const FitSchedule& stages) {
    return fit_frame(hand_, frame, {expected, angles_}, stages, options_.threads);
  };
  // Mostly the hand is where it is expected, and the last stage alone finds it there.
  if (schedule.stages.size() > 1 && std::isfinite(usual_energy())) {
    const FrameFit near = fit_by({{schedule.stages.back()}});
    if (near.report.energy <= kNearEnergyRatio * usual_energy() && is_hand(frame, near)) {
      return near;
    }
  }
  const FrameFit fit = fit_by(schedule);
  return is_hand(frame, fit) ? std::optional(fit) : std::nullopt;
}

std::optional<FrameFit> HandTracker::search(const FitFrame& frame) const {
  if (!frame.hull && !frame.landmarks) return std::nullopt;
  const bool knows_angles = !energies_.empty();
  const FrameFit found = fit_frame_from_nothing(
      hand_, frame, knows_angles ? std::vector<JointAngles>{angles_} : typical_angles(),
      knows_angles ? holding(options_.search, angles_, kDeviationsOnceLost) : options_.search,
      options_.threads);
  // Once more as frames are followed, so that energies can be compared.
  const FrameFit fit = fit_frame(hand_, frame, found.pose, options_.follow, options_.threads);
  return is_hand(frame, fit) ? std::optional(fit) : std::nullopt;
}

void HandTracker::learn(const FrameFit& fit) {
  last_but_one_ = last_;
  last_ = fit.pose.world_from_hand;
  angles_ = fit.pose.angles;
  deviations_ =
      fit.report.angle_covariance.diagonal().cwiseMax(0.0).cwiseSqrt().cwiseMax(kLeastDeviation);
  energies_.push_back(fit.report.energy);
  if (energies_.size() > kEnergiesKept) energies_.pop_front();
}

TrackedFrame HandTracker::next(const FitFrame& frame) {
  TrackedFrame tracked;
  std::optional<FrameFit> fit;
  if (last_) {
    fit = follow(frame);
    tracked.state = TrackState::followed;
  }
  if (!fit) {
    last_.reset();
    last_but_one_.reset();
    fit = search(frame);
    tracked.state = TrackState::found;
  }
  if (fit) {
    learn(*fit);
    tracked.pose = fit->pose;
  } else {
    tracked.state = TrackState::lost;
  }
  tracked.angles = angles_;
  tracked.standard_deviations = deviations_;
  return tracked;
}

}  // namespace tegata
