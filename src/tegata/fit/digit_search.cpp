// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/digit_search.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tegata/fit/start.h"

namespace tegata {
namespace {

// More frames, or finer stages than the first, tell little more of which of two bends is better.
constexpr std::size_t kTrialFrames = 6;
// And these are enough to tell which bends are worth following.
constexpr std::size_t kFirstFrames = 3;
// Bends that differ by less at every joint end alike [rad].
constexpr double kAlike = 0.35;
// Steps after which proposals are compared, and how many of them are followed to the end.
constexpr int kFirstSteps = 3;
constexpr std::size_t kFollowed = 3;
constexpr int kMostRounds = 4;
// A bend must win by so much of the energy; less is chance.
constexpr double kLeastGain = 0.002;

using DigitAngles = Eigen::Matrix<double, kAnglesPerDigit, 1>;

DigitAngles digit_angles(const JointAngles& angles, int digit) {
  return angles.segment<kAnglesPerDigit>(kAnglesPerDigit * digit);
}

JointAngles with_bend(JointAngles angles, int digit, DigitAngles bend) {
  // A finger is spread from its neighbours, not like them.
  if (digit > 0) bend[0] = relaxed_angles()[kAnglesPerDigit * digit];
  angles.segment<kAnglesPerDigit>(kAnglesPerDigit * digit) = bend;
  return angles;
}

// What the angles may be instead: digits that took the place of others come out as bent like these,
// and what took two fingers for one has one too many in the right place. What is much like the
// angles themselves or another proposal would come out like it.
std::vector<JointAngles> proposals(const JointAngles& angles) {
  std::vector<JointAngles> proposed;
  const auto propose = [&](const JointAngles& other) {
    const auto is_alike = [&other](const JointAngles& known) {
      return (known - other).cwiseAbs().maxCoeff() < kAlike;
    };
    if (!is_alike(angles) && std::none_of(proposed.begin(), proposed.end(), is_alike)) {
      proposed.push_back(other);
    }
  };
  for (const JointAngles& typical : typical_angles()) {
    for (int digit = 0; digit < kDigitCount; ++digit) {
      propose(with_bend(angles, digit, digit_angles(typical, digit)));
    }
  }
  for (int digit = 1; digit < kDigitCount; ++digit) {
    for (int other = 1; other < kDigitCount; ++other) {
      if (std::abs(other - digit) > 2 || other == digit) continue;
      propose(with_bend(angles, digit, digit_angles(angles, other)));
    }
  }
  for (int digit = 1; digit + 1 < kDigitCount; ++digit) {
    const DigitAngles first = digit_angles(angles, digit), second = digit_angles(angles, digit + 1);
    propose(with_bend(with_bend(angles, digit, second), digit + 1, first));
  }
  // A hand that is turned a little has every finger in the place of the next.
  for (const int step : {1, -1}) {
    JointAngles shifted = angles;
    for (int digit = 1; digit < kDigitCount; ++digit) {
      const int from = std::clamp(digit + step, 1, kDigitCount - 1);
      shifted = with_bend(shifted, digit, digit_angles(angles, from));
    }
    propose(shifted);
  }
  for (int like = 1; like < kDigitCount; ++like) {
    JointAngles all = angles;
    for (int digit = 1; digit < kDigitCount; ++digit) {
      all = with_bend(all, digit, digit_angles(angles, like));
    }
    propose(all);
  }
  return proposed;
}

struct Trial {
  HandEstimate estimate;
  double energy = 0.0;
};

// The poses of some frames, by position in all.
HandEstimate some_of(const HandEstimate& all, const std::vector<std::size_t>& positions) {
  HandEstimate some{all.angles, {}};
  for (const std::size_t f : positions) some.world_from_hand.push_back(all.world_from_hand[f]);
  return some;
}

std::vector<const FitFrame*> some_of(std::span<const FitFrame* const> all,
                                     const std::vector<std::size_t>& positions) {
  std::vector<const FitFrame*> some;
  for (const std::size_t f : positions) some.push_back(all[f]);
  return some;
}

// The best of what the proposals for an estimate become.
std::optional<Trial> best_trial(const FitHand& hand, std::span<const FitFrame* const> frames,
                                const FitStage& stage, int threads, const HandEstimate& estimate) {
  FitStage first_steps = stage;
  first_steps.most_iterations = kFirstSteps;
  const std::vector<std::size_t> few = spread(frames.size(), kFirstFrames);
  const std::vector<const FitFrame*> first_frames = some_of(frames, few);
  const HandEstimate first = some_of(estimate, few);
  std::vector<Trial> trials;
  for (const JointAngles& angles : proposals(estimate.angles)) {
    Trial& trial = trials.emplace_back(Trial{{angles, first.world_from_hand}});
    trial.energy = minimise(hand, first_frames, first_steps, threads, trial.estimate).energy;
  }
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.energy < b.energy; });
  trials.resize(std::min(trials.size(), kFollowed));
  for (Trial& trial : trials) {
    HandEstimate followed{trial.estimate.angles, estimate.world_from_hand};
    for (std::size_t i = 0; i < few.size(); ++i) {
      followed.world_from_hand[few[i]] = trial.estimate.world_from_hand[i];
    }
    trial.estimate = std::move(followed);
    trial.energy = minimise(hand, frames, stage, threads, trial.estimate).energy;
  }
  const auto best =
      std::min_element(trials.begin(), trials.end(),
                       [](const Trial& a, const Trial& b) { return a.energy < b.energy; });
  return best == trials.end() ? std::nullopt : std::optional(*best);
}

}  // namespace

std::optional<SolverReport> reseat_digits(const FitHand& hand,
                                          std::span<const FitFrame* const> frames,
                                          const FitSchedule& schedule, int threads,
                                          HandEstimate& estimate) {
  const std::vector<std::size_t> positions = spread(frames.size(), kTrialFrames);
  const std::vector<const FitFrame*> few = some_of(frames, positions);
  HandEstimate best = some_of(estimate, positions);
  const FitStage& coarse = schedule.stages.front();
  double energy = minimise(hand, few, coarse, threads, best).energy;
  bool is_any_better = false;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::optional<Trial> better = best_trial(hand, few, coarse, threads, best);
    if (!better || better->energy > (1.0 - kLeastGain) * energy) break;
    energy = better->energy;
    best = better->estimate;
    is_any_better = true;
  }
  if (!is_any_better) return std::nullopt;

  FitStage last = schedule.stages.back();
  HandEstimate after{best.angles, estimate.world_from_hand};
  const SolverReport report = minimise(hand, frames, schedule, threads, after);
  last.most_iterations = 0;
  const double energy_before = minimise(hand, frames, last, threads, estimate).energy;
  if (report.energy > (1.0 - kLeastGain) * energy_before) return std::nullopt;
  estimate = std::move(after);
  return report;
}

}  // namespace tegata
