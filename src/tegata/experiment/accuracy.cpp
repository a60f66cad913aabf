// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/text.h"
#include "tegata/experiment/known_take.h"
#include "tegata/experiment/table1.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/hand/built_in_hand.h"

namespace tegata {
namespace {

constexpr int kThumbAngles = 4;
std::string_view mode_title(SimulatedMode mode) {
  switch (mode) {
    case SimulatedMode::infrared:
      return "infrared, object not seen";
    case SimulatedMode::mask:
      return "masks, object unknown";
    case SimulatedMode::clean:
      return "nothing in front";
  }
  return "";
}

struct Measure {
  const char* title;
  const char* key;
  double TakeAccuracy::*value;
};
constexpr std::array<Measure, 3> kMeasures = {
    Measure{"surface error [mm]", "surface_error_mm", &TakeAccuracy::surface_mm},
    Measure{"joint angle error [deg]", "angle_error_deg", &TakeAccuracy::angle_deg},
    Measure{"thumb angle error [deg]", "thumb_error_deg", &TakeAccuracy::thumb_deg}};

TakeAccuracy accuracy_of(const FitHand& hand, const KnownTake& known) {
  GraspFitOptions options;
  options.threads = 1;
  const GraspFit fit = fit_grasp(hand, known.prepared, options, {});
  const JointAngles off = (fit.angles - *known.truth.front().angles).cwiseAbs();
  return {surface_error_mm(*hand.model, fit.poses, known),
          angle_error_deg(fit.poses, known, kAngleCount),
          angle_error_deg(fit.poses, known, kThumbAngles),
          (off.array() <= fit.standard_deviations.array()).cast<double>().mean()};
}

double mean_share_within(const std::vector<TakeAccuracy>& takes) {
  return error_range(takes, &TakeAccuracy::share_within).mean;
}

}  // namespace

ErrorRange error_range(const std::vector<TakeAccuracy>& takes, double TakeAccuracy::*measure) {
  if (takes.empty()) throw Error("accuracy: got no takes, expected one or more");
  std::vector<double> values;
  ErrorRange range;
  for (const TakeAccuracy& take : takes) {
    values.push_back(take.*measure);
    range.mean += take.*measure / static_cast<double>(takes.size());
  }
  std::sort(values.begin(), values.end());
  range.median = values[values.size() / 2];
  range.worst = values.back();
  return range;
}

Accuracy run_accuracy(const AccuracyOptions& options, const Observer& observer) {
  if (options.seed_count < 1 || options.frame_count < 1 || options.modes.empty()) {
    throw Error("accuracy: got ", options.modes.size(), " modes, ", options.seed_count,
                " seeds and ", options.frame_count, " frames, expected at least one of each");
  }
  const HandModel model = built_in_hand({}, Side::right);
  const FitHand hand(model);
  Accuracy accuracy{options.seed_count, options.frame_count, {}};
  const auto seed_count = static_cast<std::size_t>(options.seed_count);
  const std::size_t in_mode = kTable1Grasps.size() * seed_count;
  std::mutex one_at_a_time;
  std::size_t done = 0;
  const std::size_t count = options.modes.size() * in_mode;
  std::vector<TakeAccuracy> takes(count);
  observer.progress("takes", 0, count);
  parallel_for(count, options.threads, [&](std::size_t i) {
    SimulationOptions room;
    room.mode = options.modes[i / in_mode];
    room.grasp = kTable1Grasps[i % in_mode / seed_count];
    room.seed = 1 + i % seed_count;
    room.frame_count = options.frame_count;
    room.width = options.width;
    room.height = options.height;
    room.threads = 1;
    const KnownTake known = make_known_take(model, room, options.folder / text("take-", i));
    takes[i] = accuracy_of(hand, known);
    const std::lock_guard lock(one_at_a_time);
    observer.progress("takes", ++done, count);
  });
  for (std::size_t i = 0; i < count; ++i) {
    accuracy.takes[options.modes[i / in_mode]].push_back(takes[i]);
  }
  return accuracy;
}

std::string accuracy_text(const Accuracy& accuracy) {
  std::string text = fmt::format(
      "{} takes of each kind: cylinder, pinch and lateral, seeds 1 to {}; {} frames of three "
      "cameras\n\n",
      accuracy.takes.begin()->second.size(), accuracy.seed_count, accuracy.frame_count);
  for (const Measure& measure : kMeasures) {
    text += fmt::format("{:<28}{:>8}{:>8}{:>8}\n", measure.title, "mean", "median", "worst");
    for (const auto& [mode, takes] : accuracy.takes) {
      const ErrorRange range = error_range(takes, measure.value);
      text += fmt::format("  {:<26}{:>8.2f}{:>8.2f}{:>8.2f}\n", mode_title(mode), range.mean,
                          range.median, range.worst);
    }
  }
  text += "true angles within one stated standard deviation (68 % if it is right)\n";
  for (const auto& [mode, takes] : accuracy.takes) {
    text += fmt::format("  {:<26}{:>6.0f} %\n", mode_title(mode), 100.0 * mean_share_within(takes));
  }
  return text;
}

std::string accuracy_json(const Accuracy& accuracy) {
  nlohmann::ordered_json json = {
      {"experiment", "accuracy"}, {"seeds", accuracy.seed_count}, {"frames", accuracy.frame_count}};
  const auto seed_count = static_cast<std::size_t>(accuracy.seed_count);
  for (const auto& [mode, takes] : accuracy.takes) {
    auto& of_mode = json["modes"][std::string(simulated_mode_name(mode))];
    for (const Measure& measure : kMeasures) {
      const ErrorRange range = error_range(takes, measure.value);
      of_mode[measure.key] = {
          {"mean", range.mean}, {"median", range.median}, {"worst", range.worst}};
    }
    of_mode["share_within_one_deviation"] = mean_share_within(takes);
    for (std::size_t i = 0; i < takes.size(); ++i) {
      nlohmann::ordered_json take = {{"grasp", simulated_grasp_name(kTable1Grasps[i / seed_count])},
                                     {"seed", 1 + i % seed_count}};
      for (const Measure& measure : kMeasures) take[measure.key] = takes[i].*measure.value;
      take["share_within_one_deviation"] = takes[i].share_within;
      of_mode["takes"].push_back(take);
    }
  }
  return json.dump() + "\n";
}

}  // namespace tegata
