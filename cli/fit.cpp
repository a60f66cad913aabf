// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "progress.h"
#include "report.h"
#include "tegata/base/stopwatch.h"
#include "tegata/export/fit_summary.h"
#include "tegata/export/frame_doubts.h"
#include "tegata/export/report_json.h"
#include "tegata/export/result_folder.h"
#include "tegata/export/viewer_page.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/pipeline/find_side.h"
#include "tegata/pipeline/fit_take.h"
#include "tegata/pipeline/frame_selection.h"
#include "tegata/pipeline/track_take.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace fit_command {

/// "auto" (nothing) or a factor; far from 1 it is for a model of a hand, or a machine's.
std::optional<double> parse_scale(const std::string& value) {
  if (value == "auto") return std::nullopt;
  double factor = 0.0;
  const char* end = value.data() + value.size();
  const auto [last, problem] = std::from_chars(value.data(), end, factor);
  if (problem != std::errc() || last != end || !(factor >= 0.05 && factor <= 20.0)) {
    throw CLI::ValidationError("--scale", "got '" + value + "', expected auto or 0.05 to 20");
  }
  return factor;
}

struct Arguments {
  std::string take, result, hand_file, side, grasp = "fixed";
  bool hulls = false, no_report = false, force = false, track = false;
  FitTakeOptions options;
  CommonOptions common;
};

/// Has the fit hand over its hulls: whole to the folder where asked for, coarse to the report.
void keep_hulls(FitTakeOptions& options, const std::filesystem::path& folder, const Take& take,
                std::map<std::string, TriangleMesh>* for_report) {
  if (!folder.empty()) std::filesystem::create_directory(folder);
  std::vector<std::string> frames;
  for (const std::size_t i : selected_frames(options.frames, take)) {
    frames.push_back(take.frame_names()[i]);
  }
  options.on_hull = [folder, for_report, count = frames.size(), wanted = frames_with_hull(frames)](
                        const std::string& frame, const TriangleMesh& hull) {
    if (!folder.empty()) write_ply(hull, folder / (frame + ".ply"));
    if (for_report != nullptr && wanted.contains(frame)) {
      (*for_report)[frame] = report_hull(hull, count);
    }
  };
}

/// Which hand to fit: the one that is asked for or that the take shows, or else that fits better.
Side side_to_fit(const Arguments& arguments, Take& take, const Observer& observer) {
  const bool is_known = take.info().side || !arguments.side.empty() || !arguments.hand_file.empty();
  if (is_known) return choose_side(take, arguments.side);
  PrepareOptions options = arguments.options;
  options.threads = arguments.common.threads;
  const SideChoice choice = find_side(take, built_in_hand(HandShape{}, Side::right),
                                      built_in_hand(HandShape{}, Side::left), options, observer);
  observer.warn(fmt::format(
      "the take does not say which hand it shows: {} the {} one, as the other fits {:.2f} times "
      "worse; --side or take.toml can say",
      choice.lead < kSureSideLead ? "perhaps" : "taken for", side_name(choice.side), choice.lead));
  return choice.side;
}

/// How far a frame's angles may leave those of the one before [rad].
double drift_of(GraspConstraint grasp) {
  switch (grasp) {
    case GraspConstraint::fixed:
      return 0.004;
    case GraspConstraint::soft:
      return 0.02;
    case GraspConstraint::free:
      break;
  }
  return 0.15;
}

/// As a whole or, with --track, as a stream.
Result fitted(const Arguments& arguments, Take& take, const HandModel& hand,
              const Observer& observer) {
  const FitTakeOptions& options = arguments.options;
  if (!arguments.track) return fit_take(take, hand, options, observer);
  if (options.method == FitMethod::paper) {
    throw Error("--track: got --method paper as well, expected the default method");
  }
  if (!options.scale) {
    throw Error(
        "--track: got --scale auto as well, expected a factor: a stream is not seen twice; `tegata "
        "hand personalise` finds the hand's size");
  }
  TrackTakeOptions track;
  static_cast<PrepareOptions&>(track) = options;
  track.track.drift = drift_of(options.fit.grasp);
  track.track.threads = options.threads;
  return track_take(take, hand, track, observer);
}

void print_json(const Arguments& arguments, const Result& result, double seconds) {
  nlohmann::ordered_json json;
  json["result"] = arguments.result;
  json["frames"] = result.frames.size();
  json["statuses"] = count_statuses(result);
  const FitVerdict verdict = fit_verdict(result, frame_doubts(result));
  json["verdict"] = verdict.word;
  json["trusted"] = verdict.trusted;
  json["silhouette_iou"] = mean_overlaps(result);
  if (result.start) {
    json["start"] = {{"frame", result.start->frame}};
    if (std::isfinite(result.start->lead)) json["start"]["lead"] = result.start->lead;
  }
  json["iterations"] = result.iterations;
  json["termination"] = result.termination;
  json["scale"] = result.model_scale;
  if (result.model_scale_standard_deviation) {
    json["scale_standard_deviation"] = *result.model_scale_standard_deviation;
  }
  json["seconds"] = seconds;
  std::cout << json.dump() << "\n";
}

void print_summary(const Arguments& arguments, const Result& result, double seconds) {
  std::cout << fit_summary(result);
  if (result.model_scale_standard_deviation) {
    std::cout << fmt::format("scale of the hand: {:.3f}, give or take {:.3f}\n", result.model_scale,
                             *result.model_scale_standard_deviation);
  }
  std::cout << fmt::format("after {:.1f} s the fit ended with: {}\n", seconds, result.termination);
  std::cout << fmt::format("result in {}: angles.csv, hand.glb, meshes, result.json\n",
                           arguments.result);
  if (arguments.no_report) {
    std::cout << fmt::format("look at it: tegata picture {} --take {}{}{} -o picture.png\n",
                             arguments.result, arguments.take,
                             arguments.hand_file.empty() ? "" : " --hand ", arguments.hand_file);
  } else {
    std::cout << fmt::format("look at {}\n",
                             (std::filesystem::path(arguments.result) / "report.html").string());
  }
}

void run(Arguments& arguments) {
  const Stopwatch stopwatch;
  Take take = Take::open(arguments.take);
  StagedFolder folder(arguments.result, arguments.force, "result.json");

  FitTakeOptions& options = arguments.options;
  options.threads = arguments.common.threads;
  // Where the result goes there is room for the frames as well.
  options.scratch_folder = folder.path().parent_path();
  options.fit.grasp = grasp_constraint_from_name(arguments.grasp);
  if (!arguments.no_report && viewer_page().empty()) {
    arguments.no_report = true;
    if (!arguments.common.quiet) {
      std::cerr << "no report.html: this program was built without it (TEGATA_VIEWER=OFF)\n";
    }
  }
  std::map<std::string, TriangleMesh> hulls;
  keep_hulls(options, arguments.hulls ? folder.path() / "hulls" : std::filesystem::path{}, take,
             arguments.no_report ? nullptr : &hulls);
  Result result;
  {
    Progress progress(arguments.common.quiet);
    const HandModel asked =
        load_hand(arguments.hand_file, side_to_fit(arguments, take, progress.observer()));
    result = fitted(arguments, take, asked, progress.observer());
    const HandModel hand = scaled(asked, result.model_scale);
    write_result_files(result, hand, folder.path(), take.rig());
    if (!arguments.no_report) {
      // What there is to warn of was said when the frames were fitted.
      Observer observer = progress.observer();
      observer.on_warning = nullptr;
      write_report(result, hand, {&take, options.segmentation, std::move(hulls), options.threads},
                   folder.path() / "report.html", observer);
    }
  }
  folder.commit();
  if (arguments.common.json) {
    print_json(arguments, result, stopwatch.seconds());
  } else {
    print_summary(arguments, result, stopwatch.seconds());
  }
}

}  // namespace fit_command

void add_fit_command(CLI::App& program) {
  using namespace fit_command;
  const auto arguments = std::make_shared<Arguments>();
  FitTakeOptions& options = arguments->options;
  CLI::App* command = program.add_subcommand("fit", "Fit a hand to a take");
  command->add_option("TAKE", arguments->take, "Folder with calibration.toml and pictures")
      ->required();
  command->add_option("-o,--output", arguments->result, "Folder to make")->required();
  command->add_option(
      "--hand", arguments->hand_file,
      "A hand from a file (GLB, glTF, TOML); else the built-in one of the mean adult");
  command->add_option("--side", arguments->side, "Which hand, where the take does not say")
      ->check(CLI::IsMember({"right", "left"}));
  add_segmentation_option(*command, options.segmentation);
  command
      ->add_option_function<std::string>(
          "--method",
          [arguments](const std::string& name) {
            arguments->options.method = name == "paper" ? FitMethod::paper : FitMethod::all_terms;
          },
          "default, or paper: by the visual hull alone, as Ogawara et al. 2003")
      ->check(CLI::IsMember({"default", "paper"}))
      ->default_str("default");
  add_grasp_option(*command, arguments->grasp);
  command->add_flag("--track", arguments->track,
                    "As a stream: each frame by those before it, in memory that does not grow");
  command
      ->add_option_function<std::string>(
          "--scale",
          [arguments](const std::string& value) { arguments->options.scale = parse_scale(value); },
          "auto: find the hand's size as well; or a factor on it")
      ->default_str("1");
  add_frames_option(*command, options.frames);
  add_voxel_option(*command, options.hull);
  command->add_option("--triangles", options.hull.triangle_count, "Of the simplified visual hull")
      ->check(CLI::Range(100, 10000000))
      ->capture_default_str();
  command->add_flag("--hulls", arguments->hulls, "Write the visual hulls as well");
  command->add_flag("--no-report", arguments->no_report, "No report.html");
  command->add_flag("--force", arguments->force, "Replace the result folder where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata fit demo/take -o demo/result\n");
  command->callback([arguments, command] {
    FitTakeOptions& asked = arguments->options;
    const bool has_voxel = command->count("--voxel-mm") > 0;
    if (!has_voxel) asked.hull.voxel_size *= asked.scale.value_or(1.0);
    run(*arguments);
  });
}

}  // namespace tegata
