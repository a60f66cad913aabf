// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/table1.h"

#include <cmath>
#include <mutex>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/text.h"
#include "tegata/experiment/known_take.h"
#include "tegata/fit/support.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/pipeline/paper_take.h"

namespace tegata {
namespace {

KnownTake make_take(const HandModel& hand, SimulatedGrasp grasp, std::uint64_t seed,
                    const Table1Options& options) {
  SimulationOptions room;
  room.grasp = grasp;
  room.seed = seed;
  room.frame_count = options.frame_count;
  room.width = options.width;
  room.height = options.height;
  room.threads = 1;
  return make_known_take(hand, room, options.folder / text(simulated_grasp_name(grasp), "-", seed));
}

FitError error_of(const HandModel& hand, const std::vector<HandPose>& poses,
                  const KnownTake& known) {
  return {surface_error_mm(hand, poses, known), angle_error_deg(poses, known, kAngleCount)};
}

struct TakeErrors {
  std::array<FitError, kTable1FitCount> fits;
  WeightRecord weights;
};

WeightRecord record_of(const FitHand& hand, const PreparedTake& take, const PaperFit& fit) {
  WeightRecord record;
  for (std::size_t k = 0; k < fit.poses.size(); ++k) {
    const PreparedFrame frame = take.frames().restored(take.usable()[k]);
    record.frames.push_back({frame.name, fit.weights[k],
                             bone_support(hand, hand.posed(fit.poses[k]), frame.frame.views)});
  }
  return record;
}

TakeErrors fit_by_all(const FitHand& hand, const KnownTake& known) {
  const auto at = [](Table1Fit fit) { return static_cast<std::size_t>(fit); };
  const HandModel& model = *hand.model;
  TakeErrors errors;

  PaperFitOptions paper;
  paper.threads = 1;
  const PaperFit by_paper = fit_paper(hand, paper_frames(known.prepared), paper, {});
  errors.fits[at(Table1Fit::paper_single)] = error_of(model, by_paper.single_poses, known);
  errors.fits[at(Table1Fit::paper_all)] = error_of(model, by_paper.poses, known);
  errors.weights = record_of(hand, known.prepared, by_paper);

  GraspFitOptions options;
  options.threads = 1;
  errors.fits[at(Table1Fit::default_all)] =
      error_of(model, fit_grasp(hand, known.prepared, options, {}).poses, known);
  options.grasp = GraspConstraint::free;
  errors.fits[at(Table1Fit::default_single)] =
      error_of(model, fit_grasp(hand, known.prepared, options, {}).poses, known);
  return errors;
}

}  // namespace

std::string_view table1_fit_name(Table1Fit fit) {
  switch (fit) {
    case Table1Fit::paper_single:
      return "paper_single";
    case Table1Fit::paper_all:
      return "paper_all";
    case Table1Fit::default_single:
      return "default_single";
    case Table1Fit::default_all:
      return "default_all";
  }
  return "";
}

ErrorSpread spread_of(const std::vector<FitError>& errors) {
  ErrorSpread spread;
  const double count = static_cast<double>(errors.size());
  for (const FitError& error : errors) {
    spread.mean.surface_mm += error.surface_mm / count;
    spread.mean.angle_deg += error.angle_deg / count;
  }
  if (errors.size() < 2) return spread;
  for (const FitError& error : errors) {
    const double surface = error.surface_mm - spread.mean.surface_mm;
    const double angle = error.angle_deg - spread.mean.angle_deg;
    spread.deviation.surface_mm += surface * surface / (count - 1.0);
    spread.deviation.angle_deg += angle * angle / (count - 1.0);
  }
  spread.deviation.surface_mm = std::sqrt(spread.deviation.surface_mm);
  spread.deviation.angle_deg = std::sqrt(spread.deviation.angle_deg);
  return spread;
}

Table1 run_table1(const Table1Options& options, const Observer& observer) {
  if (options.seed_count < 1 || options.frame_count < 1) {
    throw Error("table1: got ", options.seed_count, " seeds and ", options.frame_count,
                " frames, expected at least one of each");
  }
  const HandModel model = built_in_hand({}, Side::right);
  const FitHand hand(model);
  const auto seed_count = static_cast<std::size_t>(options.seed_count);
  std::vector<TakeErrors> of_takes(kTable1Grasps.size() * seed_count);
  std::mutex one_at_a_time;
  std::size_t done = 0;
  observer.progress("takes", 0, of_takes.size());
  parallel_for(of_takes.size(), options.threads, [&](std::size_t i) {
    const SimulatedGrasp grasp = kTable1Grasps[i / seed_count];
    of_takes[i] = fit_by_all(hand, make_take(model, grasp, 1 + i % seed_count, options));
    const std::lock_guard lock(one_at_a_time);
    observer.progress("takes", ++done, of_takes.size());
  });

  Table1 table;
  table.seed_count = options.seed_count;
  table.frame_count = options.frame_count;
  table.weights = of_takes.front().weights;
  for (std::size_t grasp = 0; grasp < kTable1Grasps.size(); ++grasp) {
    for (std::size_t fit = 0; fit < kTable1FitCount; ++fit) {
      std::vector<FitError>& errors = table.of_seeds[grasp][fit];
      for (std::size_t seed = 0; seed < seed_count; ++seed) {
        errors.push_back(of_takes[grasp * seed_count + seed].fits[fit]);
      }
      table.errors[grasp][fit] = spread_of(errors);
    }
  }
  return table;
}

}  // namespace tegata
