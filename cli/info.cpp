// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "tegata/take/take.h"

#include "tegata/base/angle.h"

namespace tegata {
namespace info_command {

struct Arguments {
  std::string folder;
  CommonOptions common;
};

std::string_view source_name(PictureSource source) {
  switch (source) {
    case PictureSource::images:
      return "images";
    case PictureSource::videos:
      return "videos";
    case PictureSource::masks:
      return "masks";
  }
  throw Error("picture source: got ", static_cast<int>(source), ", expected one of the three");
}

nlohmann::ordered_json describe_take(const Take& take) {
  const TakeInfo& info = take.info();
  nlohmann::ordered_json json;
  json["kind"] = "take";
  json["name"] = info.name;
  json["hand"] = info.side ? nlohmann::json(side_name(*info.side)) : nlohmann::json();
  json["fps"] = info.fps;
  json["source"] = source_name(take.source());
  json["frames"] = take.frame_names().size();
  json["initial_pose"] = info.initial_landmarks.has_value();
  json["segmentation"] = info.segmentation
                             ? nlohmann::json(segmentation_method_name(*info.segmentation))
                             : nlohmann::json();
  json["truth"] = std::filesystem::exists(take.folder() / "truth.json");
  for (const Camera& camera : take.rig()) {
    json["cameras"].push_back({{"name", camera.name},
                               {"size", {camera.width, camera.height}},
                               {"focal_length_px", {camera.fx, camera.fy}},
                               {"distorted", camera.is_distorted()}});
  }
  return json;
}

void print_take(const Take& take) {
  const TakeInfo& info = take.info();
  const std::vector<std::string>& frames = take.frame_names();
  std::cout << fmt::format("take {}: {} frames ({} .. {}) from {}, {} a second\n", info.name,
                           frames.size(), frames.front(), frames.back(), source_name(take.source()),
                           info.fps);
  std::cout << fmt::format(
      "hand: {}; initial pose: {}; segmentation: {}; truth: {}\n",
      info.side ? side_name(*info.side) : "not said", info.initial_landmarks ? "given" : "none",
      info.segmentation ? segmentation_method_name(*info.segmentation) : "chosen from the pictures",
      std::filesystem::exists(take.folder() / "truth.json") ? "there" : "none");
  for (const Camera& camera : take.rig()) {
    const Eigen::Vector3d center = camera.center_in_world();
    std::cout << fmt::format(
        "camera {}: {}x{}, focal length {:.1f} x {:.1f} px{}, at ({:.3f}, {:.3f}, {:.3f}) m\n",
        camera.name, camera.width, camera.height, camera.fx, camera.fy,
        camera.is_distorted() ? ", distorted" : "", center.x(), center.y(), center.z());
  }
}

nlohmann::ordered_json describe_result(const Result& result) {
  nlohmann::ordered_json json;
  json["kind"] = "result";
  json["take"] = result.take;
  json["hand"] = side_name(result.side);
  json["model"] = result.model_name;
  json["frames"] = result.frames.size();
  json["statuses"] = count_statuses(result);
  json["silhouette_iou"] = mean_overlaps(result);
  for (const ResultFrame& frame : result.frames) {
    if (!frame.left_out.empty()) json["left_out"][frame.name] = frame.left_out;
  }
  for (int i = 0; i < kAngleCount; ++i) {
    json["grasp_deg"][std::string(angle_names()[static_cast<std::size_t>(i)])] =
        result.grasp_angles[i] * kDegreesPerRadian;
  }
  json["termination"] = result.termination;
  return json;
}

void print_result(const Result& result) {
  std::cout << fmt::format("result of {}: {} hand, model {}, {} frames\n", result.take,
                           side_name(result.side), result.model_name, result.frames.size());
  for (const auto& [status, count] : count_statuses(result)) {
    std::cout << fmt::format("  {} frames: {}\n", count, status);
  }
  LeftOut left_out;
  for (const ResultFrame& frame : result.frames) left_out.add(frame.name, frame.left_out);
  std::cout << left_out.lines();
  std::cout << fmt::format("mean silhouette overlap: {}\n", overlap_text(mean_overlaps(result)));
  std::cout << fmt::format("the fit ended with: {}\n", result.termination);
  std::cout << "grasp [deg], with standard deviations:\n";
  for (int i = 0; i < kAngleCount; ++i) {
    std::cout << fmt::format("  {:<22} {:6.1f} +- {:.1f}\n",
                             angle_names()[static_cast<std::size_t>(i)],
                             result.grasp_angles[i] * kDegreesPerRadian,
                             result.grasp_standard_deviations[i] * kDegreesPerRadian);
  }
}

void run(const Arguments& arguments) {
  const std::filesystem::path result_file = std::filesystem::path(arguments.folder) / "result.json";
  if (std::filesystem::exists(result_file)) {
    const Result result = read_result_json(result_file);
    if (arguments.common.json) {
      std::cout << describe_result(result).dump() << "\n";
    } else {
      print_result(result);
    }
  } else {
    const Take take = Take::open(arguments.folder);
    if (arguments.common.json) {
      std::cout << describe_take(take).dump() << "\n";
    } else {
      print_take(take);
    }
  }
}

}  // namespace info_command

void add_info_command(CLI::App& program) {
  using namespace info_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("info", "Say what a take or a result holds");
  command->add_option("FOLDER", arguments->folder, "A take or a result")->required();
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata info demo/take\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
