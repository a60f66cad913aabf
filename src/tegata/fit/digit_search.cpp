// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/digit_search.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tegata/fit/start.h"

namespace tegata {
namespace {

// More frames, or finer stages than the first, tell little more of which of two bends is better.
constexpr std::size_t kTrialFrames = 4;
// A bend must win by so much of the energy; less is chance.
constexpr double kLeastGain = 0.002;

using DigitAngles = Eigen::Matrix<double, kAnglesPerDigit, 1>;

DigitAngles digit_angles(const JointAngles& angles, int digit) {
  return angles.segment<kAnglesPerDigit>(kAnglesPerDigit * digit);
}

// What a digit may be instead of what it is.
std::vector<DigitAngles> other_bends(const JointAngles& angles, int digit) {
  std::vector<DigitAngles> bends;
  if (digit == 0) {
    for (const JointAngles& typical : typical_angles()) bends.push_back(digit_angles(typical, 0));
    return bends;
  }
  const int before = digit > 1 ? digit - 1 : digit + 1;
  const int behind = digit + 1 < kDigitCount ? digit + 1 : digit - 1;
  DigitAngles mean = 0.5 * (digit_angles(angles, before) + digit_angles(angles, behind));
  mean[0] = relaxed_angles()[kAnglesPerDigit * digit];  // spread from neighbours, not like them
  bends.push_back(mean);
  return bends;
}

SolverReport settle(const FitHand& hand, std::span<const FitFrame* const> frames,
                    const FitSchedule& schedule, int threads, HandEstimate& estimate) {
  SolverReport report;
  int iterations = 0;
  for (const FitStage& stage : schedule.stages) {
    report = minimise(hand, frames, stage, threads, estimate);
    iterations += report.iterations;
  }
  report.iterations = iterations;
  return report;
}

}  // namespace

std::optional<SolverReport> reseat_digits(const FitHand& hand,
                                          std::span<const FitFrame* const> frames,
                                          const FitSchedule& schedule, int threads,
                                          HandEstimate& estimate) {
  std::vector<const FitFrame*> few;
  HandEstimate best{estimate.angles, {}};
  const std::size_t count = std::min(kTrialFrames, frames.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t f = count == 1 ? 0 : i * (frames.size() - 1) / (count - 1);
    few.push_back(frames[f]);
    best.world_from_hand.push_back(estimate.world_from_hand[f]);
  }
  const FitSchedule coarse{{schedule.stages.front()}};
  double energy = settle(hand, few, coarse, threads, best).energy;
  bool is_any_better = false;
  for (int digit = 0; digit < kDigitCount; ++digit) {
    for (const DigitAngles& bend : other_bends(best.angles, digit)) {
      HandEstimate trial = best;
      trial.angles.segment<kAnglesPerDigit>(kAnglesPerDigit * digit) = bend;
      const double trial_energy = settle(hand, few, coarse, threads, trial).energy;
      if (trial_energy > (1.0 - kLeastGain) * energy) continue;
      energy = trial_energy;
      best = std::move(trial);
      is_any_better = true;
    }
  }
  if (!is_any_better) return std::nullopt;

  FitStage last = schedule.stages.back();
  HandEstimate after{best.angles, estimate.world_from_hand};
  const SolverReport report = settle(hand, frames, schedule, threads, after);
  last.most_iterations = 0;
  if (report.energy >= minimise(hand, frames, last, threads, estimate).energy) return std::nullopt;
  estimate = std::move(after);
  return report;
}

}  // namespace tegata
