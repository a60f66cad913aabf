// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "progress.h"
#include "tegata/base/stopwatch.h"
#include "tegata/export/report_page.h"
#include "tegata/export/result_folder.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/pipeline/fit_take.h"
#include "tegata/pipeline/overlays.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

constexpr std::size_t kReportFrames = 8;
constexpr int kReportPictureWidth = 480;
constexpr int kReportJpegQuality = 80;

struct Arguments {
  std::string take, result, hand_file, side, grasp = "fixed";
  bool hulls = false, no_report = false, force = false;
  FitTakeOptions options;
  CommonOptions common;
};

Side choose_side(const Take& take, const std::string& asked) {
  const std::optional<Side>& known = take.info().side;
  if (!known && asked.empty()) {
    throw Error(take.folder().string(),
                ": the take does not say which hand it shows; give --side right or left, or set "
                "hand in take.toml");
  }
  if (asked.empty()) return *known;
  const Side side = side_from_name(asked);
  if (known && *known != side) {
    throw Error(take.folder().string(), ": got --side ", asked, ", but take.toml says ",
                side_name(*known));
  }
  return side;
}

void write_report(Take& take, const Result& result, const HandModel& hand,
                  const std::optional<SegmentationMethod>& segmentation,
                  const std::filesystem::path& file) {
  std::vector<ReportPicture> pictures;
  // Without an observer: what there is to warn of was said when the frames were fitted.
  for (const Overlay& overlay : draw_overlays(
           take, result, hand, {kReportFrames, kReportPictureWidth, segmentation}, Observer{})) {
    pictures.push_back(
        {overlay.frame, overlay.camera, encode_jpeg(overlay.picture, kReportJpegQuality)});
  }
  write_report_page(result, pictures, file);
}

void print_json(const Arguments& arguments, const Result& result, double seconds) {
  nlohmann::ordered_json json;
  json["result"] = arguments.result;
  json["frames"] = result.frames.size();
  json["statuses"] = count_statuses(result);
  json["silhouette_iou"] = mean_overlaps(result);
  json["iterations"] = result.iterations;
  json["termination"] = result.termination;
  json["seconds"] = seconds;
  std::cout << json.dump() << "\n";
}

void print_summary(const Arguments& arguments, const Result& result, double seconds) {
  const std::map<std::string, int> statuses = count_statuses(result);
  const int ok = statuses.contains("ok") ? statuses.at("ok") : 0;
  std::cout << fmt::format("{} of {} frames are ok, after {:.1f} s; the fit ended with: {}\n", ok,
                           result.frames.size(), seconds, result.termination);
  for (const auto& [status, count] : statuses) {
    if (status != "ok") std::cout << fmt::format("  {} not: {}\n", count, status);
  }
  if (ok > 0) {
    std::cout << fmt::format("mean silhouette overlap: {}\n", overlap_text(mean_overlaps(result)));
  }
  std::cout << fmt::format("result in {}: {}angles.csv, hand.glb, meshes, result.json\n",
                           arguments.result, arguments.no_report ? "" : "report.html, ");
}

void run(Arguments& arguments) {
  const Stopwatch stopwatch;
  Take take = Take::open(arguments.take);
  const HandModel hand = load_hand(arguments.hand_file, choose_side(take, arguments.side));
  StagedFolder folder(arguments.result, arguments.force, "result.json");

  FitTakeOptions& options = arguments.options;
  options.threads = arguments.common.threads;
  options.fit.grasp = arguments.grasp == "free" ? GraspConstraint::free : GraspConstraint::fixed;
  if (arguments.hulls) {
    const std::filesystem::path hulls = folder.path() / "hulls";
    std::filesystem::create_directory(hulls);
    options.on_hull = [hulls](const std::string& frame, const TriangleMesh& hull) {
      write_ply(hull, hulls / (frame + ".ply"));
    };
  }
  Result result;
  {
    Progress progress(arguments.common.quiet);
    result = fit_take(take, hand, options, progress.observer());
    write_result_files(result, hand, folder.path());
    if (!arguments.no_report) {
      write_report(take, result, hand, options.segmentation, folder.path() / "report.html");
    }
  }
  folder.commit();
  if (arguments.common.json) {
    print_json(arguments, result, stopwatch.seconds());
  } else {
    print_summary(arguments, result, stopwatch.seconds());
  }
}

}  // namespace

void add_fit_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  FitTakeOptions& options = arguments->options;
  CLI::App* command = program.add_subcommand("fit", "Fit a hand to a take");
  command->add_option("TAKE", arguments->take, "Folder with calibration.toml and pictures")
      ->required();
  command->add_option("-o,--output", arguments->result, "Folder to make")->required();
  command->add_option("--hand", arguments->hand_file,
                      "A skinned hand (GLB, glTF) or a scanned one (TOML); else the built-in one");
  command->add_option("--side", arguments->side, "Which hand, where the take does not say")
      ->check(CLI::IsMember({"right", "left"}));
  add_segmentation_option(*command, options.segmentation);
  command
      ->add_option("--grasp", arguments->grasp,
                   "fixed: one set of joint angles for all frames; free: one a frame")
      ->check(CLI::IsMember({"fixed", "free"}))
      ->capture_default_str();
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
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
