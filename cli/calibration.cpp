// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "progress.h"
#include "tegata/base/angle.h"
#include "tegata/pipeline/check_calibration.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/calibration_import.h"

namespace tegata {
namespace calibration_command {

/// WIDTHxHEIGHT.
PictureSize parse_size(const std::string& value) {
  PictureSize size;
  const char* const end = value.data() + value.size();
  const auto width = std::from_chars(value.data(), end, size.width);
  const bool cross = width.ptr != end && *width.ptr == 'x';
  const auto height = std::from_chars(cross ? width.ptr + 1 : end, end, size.height);
  if (!cross || height.ec != std::errc() || height.ptr != end || size.width < 1 ||
      size.height < 1) {
    throw CLI::ValidationError("--size", "got '" + value + "', expected WIDTHxHEIGHT as 640x480");
  }
  return size;
}

struct ConvertArguments {
  std::string input, output;
  bool force = false;
  CalibrationImportOptions options;
  CommonOptions common;
};

void convert(const ConvertArguments& arguments) {
  const ImportedCalibration imported = import_calibration(arguments.input, arguments.options);
  check_free(arguments.output, arguments.force);
  write_calibration(imported.rig, arguments.output);
  if (arguments.common.json) {
    nlohmann::ordered_json json;
    json["format"] = calibration_format_name(imported.format);
    json["calibration"] = arguments.output;
    for (const Camera& camera : imported.rig) json["cameras"].push_back(camera.name);
    std::cout << json.dump() << "\n";
    return;
  }
  std::cout << fmt::format("{} cameras of {} written to {}\n", imported.rig.size(),
                           calibration_format_name(imported.format), arguments.output);
  for (const Camera& camera : imported.rig) {
    const Eigen::Vector3d center = camera.center_in_world();
    std::cout << fmt::format(
        "  {}: {}x{}, focal length {:.1f} px, {} lens, at ({:.3f}, {:.3f}, {:.3f}) m\n",
        camera.name, camera.width, camera.height, camera.fx, lens_model_name(camera.lens_model),
        center.x(), center.y(), center.z());
  }
}

void add_convert_command(CLI::App& calibration) {
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = calibration.add_subcommand(
      "convert", "Make a calibration.toml of another tool's calibration");
  command
      ->add_option("INPUT", arguments->input,
                   "A file, or the folder of a pair of files: Anipose, FreeMoCap, Caliscope, "
                   "Pose2Sim, EasyMocap, COLMAP text, Kalibr or OpenCV")
      ->required();
  command->add_option("-o,--output", arguments->output, "The calibration.toml to write")
      ->required();
  command
      ->add_option("--metres-per-unit", arguments->options.metres_per_unit,
                   "What a translation is multiplied by: 0.001 for millimetres")
      ->check(CLI::PositiveNumber);
  command->add_option_function<std::string>(
      "--size",
      [arguments](const std::string& value) { arguments->options.size = parse_size(value); },
      "WIDTHxHEIGHT of the pictures, where the file does not say it");
  command->add_flag("--force", arguments->force, "Replace the file where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata calibration convert camchain.yaml -o take/calibration.toml\n");
  command->callback([arguments] { convert(*arguments); });
}

struct CheckArguments {
  std::string take;
  CheckTakeOptions options;
  CommonOptions common;
};

void print_check_json(const TakeCheck& check, const CameraRig& rig) {
  nlohmann::ordered_json json;
  json["frames"] = check.frame_count;
  json["agrees"] = check.calibration.agrees();
  json["problems"] = nlohmann::json::array();
  for (const CalibrationProblem& problem : check.calibration.problems) {
    json["problems"].push_back({{"message", problem.message}, {"cameras", problem.cameras}});
  }
  for (const PairTangency& pair : check.calibration.pairs) {
    json["tangency"].push_back({{"cameras", {rig[pair.first].name, rig[pair.second].name}},
                                {"tangents", pair.count},
                                {"median_deg", pair.median * kDegreesPerRadian}});
  }
  json["hull_coverage"] = check.hull_coverage;
  json["object_size"] = check.calibration.object_size;
  std::cout << json.dump() << "\n";
}

void print_check(const TakeCheck& check, const CameraRig& rig) {
  std::cout << fmt::format("{} cameras, {} frames in which two or more saw the hand\n", rig.size(),
                           check.frame_count);
  for (const PairTangency& pair : check.calibration.pairs) {
    std::cout << fmt::format("  {} and {}: tangents agree to {:.2f} deg (median of {})\n",
                             rig[pair.first].name, rig[pair.second].name,
                             pair.median * kDegreesPerRadian, pair.count);
  }
  for (const auto& [camera, share] : check.hull_coverage) {
    std::cout << fmt::format("  {}: the visual hull covers {:.0f} % of the silhouette\n", camera,
                             100.0 * share);
  }
  for (const CalibrationProblem& problem : check.calibration.problems) {
    std::cout << "problem: " << problem.message << "\n";
  }
  if (!check.calibration.agrees()) return;
  std::cout
      << (check.calibration.pairs.empty()
              ? "nothing contradicts the calibration, of which these silhouettes say nothing\n"
              : "calibration and silhouettes agree\n");
}

void check(const CheckArguments& arguments) {
  Take take = Take::open(arguments.take);
  TakeCheck found;
  {
    Progress progress(arguments.common.quiet);
    CheckTakeOptions options = arguments.options;
    options.threads = arguments.common.threads;
    found = check_take(take, options, progress.observer());
  }
  if (arguments.common.json) {
    print_check_json(found, take.rig());
  } else {
    print_check(found, take.rig());
  }
  if (found.calibration.agrees()) return;
  throw Error((take.folder() / "calibration.toml").string(), ": ",
              found.calibration.problems.front().message);
}

void add_check_command(CLI::App& calibration) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command =
      calibration.add_subcommand("check", "Check a take's calibration against its silhouettes");
  command->add_option("TAKE", arguments->take, "Folder with calibration.toml and pictures")
      ->required();
  add_segmentation_option(*command, arguments->options.segmentation);
  add_frames_option(*command, arguments->options.frames);
  add_common_options(*command, arguments->common);
  command->footer(
      "Exits with 1 where something is wrong. Example: tegata calibration check take\n");
  command->callback([arguments] { check(*arguments); });
}

}  // namespace calibration_command

void add_calibration_command(CLI::App& program) {
  using namespace calibration_command;
  CLI::App* calibration =
      program.add_subcommand("calibration", "Convert and check the cameras' calibration");
  calibration->require_subcommand(1);
  add_convert_command(*calibration);
  add_check_command(*calibration);
}

}  // namespace tegata
