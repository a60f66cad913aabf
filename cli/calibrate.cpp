// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "progress.h"
#include "tegata/base/angle.h"
#include "tegata/calibrate/coverage_picture.h"
#include "tegata/pipeline/calibrate_take.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"

namespace tegata {
namespace calibrate_command {

struct Arguments {
  std::string folder, output, coverage, board, intrinsics;
  bool force = false;
  CalibrateTakeOptions options;
  CommonOptions common;
};

void print_json(const Arguments& arguments, const BoardCalibration& found) {
  nlohmann::ordered_json json;
  json["calibration"] = arguments.output;
  json["rms_px"] = found.rms;
  if (arguments.options.intrinsics_file.empty()) {
    json["intrinsics"] = nullptr;
  } else {
    json["intrinsics"] = arguments.options.intrinsics_file.string();
  }
  for (const Camera& camera : found.rig) {
    const CameraResiduals& residuals = found.cameras.at(camera.name);
    json["cameras"].push_back(
        {{"name", camera.name},
         {"rms_px", residuals.rms},
         {"views", residuals.views},
         {"points", residuals.points},
         {"coverage", residuals.coverage},
         {"direction_deviation_deg", kDegreesPerRadian * residuals.direction_deviation},
         {"focal_length_px", {camera.fx, camera.fy}}});
  }
  json["outliers"] = nlohmann::json::array();
  for (const OutlierView& view : found.outliers) {
    json["outliers"].push_back(
        {{"camera", view.camera}, {"frame", view.frame}, {"rms_px", view.rms}});
  }
  std::cout << json.dump() << "\n";
}

void print_text(const Arguments& arguments, const BoardCalibration& found) {
  std::cout << fmt::format("{} cameras, reprojected to {:.2f} px rms, written to {}\n",
                           found.rig.size(), found.rms, arguments.output);
  for (const Camera& camera : found.rig) {
    const CameraResiduals& residuals = found.cameras.at(camera.name);
    const Eigen::Vector3d center = camera.center_in_world();
    std::cout << fmt::format(
        "  {}: {:.2f} px rms, {} views, {} points on {:.0f} % of the picture, focal length {:.1f} "
        "px, at ({:.3f}, {:.3f}, {:.3f}) m\n",
        camera.name, residuals.rms, residuals.views, residuals.points, 100.0 * residuals.coverage,
        camera.fx, center.x(), center.y(), center.z());
  }
  const std::filesystem::path& lenses = arguments.options.intrinsics_file;
  if (!lenses.empty()) std::cout << "  lenses as in " << lenses.string() << "\n";
  for (const OutlierView& view : found.outliers) {
    std::cout << fmt::format("  left out: camera {}, frame {} ({:.1f} px)\n", view.camera,
                             view.frame, view.rms);
  }
}

// Says which cameras' directions the views leave open.
void warn_of_open_directions(const BoardCalibration& found, const Observer& observer) {
  constexpr double kOpen = 0.5;  // [deg]
  for (const auto& [name, residuals] : found.cameras) {
    const double deviation = kDegreesPerRadian * residuals.direction_deviation;
    if (deviation <= kOpen) continue;
    observer.warn(fmt::format(
        "camera '{}': the board was seen on {:.0f} % of its picture, which leaves open where its "
        "lens's centre is, and with it where it looks, by {:.1f} deg or more: take the board, "
        "tilted, into all corners, or calibrate the lens by closer pictures and give it with "
        "--intrinsics",
        name, 100.0 * residuals.coverage, deviation));
  }
}

void run(Arguments& arguments) {
  check_free(arguments.output, arguments.force);
  CalibrateTakeOptions& options = arguments.options;
  options.threads = arguments.common.threads;
  options.board_file = arguments.board;
  options.intrinsics_file = find_intrinsics(arguments.folder, arguments.intrinsics);
  BoardCalibration found;
  BoardRecording recording;
  {
    Progress progress(arguments.common.quiet);
    recording = read_board_recording(arguments.folder, options, progress.observer());
    BoardCalibrationOptions calibration;
    calibration.known_intrinsics = !options.intrinsics_file.empty();
    found = calibrate_rig(recording, calibration);
    warn_of_open_directions(found, progress.observer());
  }
  write_calibration(found.rig, arguments.output);
  if (!arguments.coverage.empty()) {
    write_picture(coverage_picture(recording, found), arguments.coverage);
  }
  if (arguments.common.json) {
    print_json(arguments, found);
  } else {
    print_text(arguments, found);
  }
}

}  // namespace calibrate_command

void add_calibrate_command(CLI::App& program) {
  using namespace calibrate_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("calibrate", "Calibrate cameras from pictures of a board");
  command
      ->add_option("BOARD_TAKE", arguments->folder,
                   "Folder with board.toml and images/<camera>/ or videos/<camera>.mp4")
      ->required();
  command->add_option("-o,--output", arguments->output, "The calibration.toml to write")
      ->required();
  command->add_option("--board", arguments->board, "The board's TOML, where it is not there");
  command->add_option("--coverage", arguments->coverage,
                      "A PNG to write: where in the pictures the board was seen");
  command->add_option("--intrinsics", arguments->intrinsics,
                      "A calibration whose lenses are kept, only poses are found; absent: "
                      "intrinsics.toml or camera_array.toml in the folder; find: lenses as well");
  command->add_option("--most-frames", arguments->options.most_frames, "Frames to look at")
      ->check(CLI::Range(3, 10000))
      ->capture_default_str();
  command->add_flag("--force", arguments->force, "Replace the file where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata calibrate board_take -o take/calibration.toml\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
