// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "hand_command.h"
#include "tegata/gltf/hand_gltf.h"

#include "tegata/base/angle.h"

namespace tegata {
namespace hand_command {

constexpr int kMiddleTip = 12, kIndexKnuckle = 5, kLittleKnuckle = 17;  // keypoints

struct InfoArguments {
  HandSource source;
  CommonOptions common;
};

struct ConvertArguments {
  HandSource source;
  std::string output;
  bool mirror = false;
  CommonOptions common;
};

double between(const Skeleton& skeleton, int a, int b) {
  return (skeleton.keypoints[static_cast<std::size_t>(a)] -
          skeleton.keypoints[static_cast<std::size_t>(b)])
      .norm();
}

double bone_length(const Skeleton& skeleton, int bone) {
  return between(skeleton, proximal_keypoint(bone), bone == 0 ? 9 : distal_keypoint(bone));
}

void print_json(const HandModel& hand, const MeshTopology& topology) {
  nlohmann::ordered_json json;
  json["name"] = hand.name;
  json["side"] = side_name(hand.skeleton.side);
  json["units"] = {{"length", "m"}, {"angle", "rad"}};
  json["vertices"] = hand.rest_surface.vertices.size();
  json["triangles"] = hand.rest_surface.triangles.size();
  json["closed"] = topology.closed;
  json["length"] = between(hand.skeleton, 0, kMiddleTip);
  json["knuckle_breadth"] = between(hand.skeleton, kIndexKnuckle, kLittleKnuckle);
  for (int bone = 0; bone < kBoneCount; ++bone) {
    json["bone_lengths"][std::string(bone_names()[static_cast<std::size_t>(bone)])] =
        bone_length(hand.skeleton, bone);
  }
  for (int angle = 0; angle < kAngleCount; ++angle) {
    json["angles"][std::string(angle_names()[static_cast<std::size_t>(angle)])] = {
        {"lower", angle_limits().lower[angle]},
        {"upper", angle_limits().upper[angle]},
        {"rest", hand.rest_angles[angle]}};
  }
  std::cout << json.dump() << "\n";
}

void print_text(const HandModel& hand, const MeshTopology& topology) {
  std::cout << fmt::format(
      "{}: a {} hand\n"
      "length {:.1f} mm from the wrist to the middle finger's tip, straight; {:.1f} mm between the "
      "joints of the index and little finger's knuckles\n"
      "{} vertices, {} triangles, {}\n\nbones [mm]\n",
      hand.name, side_name(hand.skeleton.side), 1e3 * between(hand.skeleton, 0, kMiddleTip),
      1e3 * between(hand.skeleton, kIndexKnuckle, kLittleKnuckle),
      hand.rest_surface.vertices.size(), hand.rest_surface.triangles.size(),
      topology.closed ? "closed" : "with holes");
  for (int bone = 0; bone < kBoneCount; ++bone) {
    std::cout << fmt::format("  {:<22}{:6.1f}\n", bone_names()[static_cast<std::size_t>(bone)],
                             1e3 * bone_length(hand.skeleton, bone));
  }
  std::cout << fmt::format("\nangles [deg]            {:>6} {:>6} {:>6}\n", "lower", "upper",
                           "rest");
  for (int angle = 0; angle < kAngleCount; ++angle) {
    std::cout << fmt::format("  {:<22}{:6.0f} {:6.0f} {:6.1f}\n",
                             angle_names()[static_cast<std::size_t>(angle)],
                             angle_limits().lower[angle] * kDegreesPerRadian,
                             angle_limits().upper[angle] * kDegreesPerRadian,
                             hand.rest_angles[angle] * kDegreesPerRadian);
  }
}

void run_info(const InfoArguments& arguments) {
  const HandModel hand = load_hand(arguments.source);
  const MeshTopology topology = inspect_topology(hand.rest_surface);
  if (arguments.common.json) {
    print_json(hand, topology);
  } else {
    print_text(hand, topology);
  }
}

void run_convert(const ConvertArguments& arguments) {
  const std::filesystem::path output = arguments.output;
  if (output.extension() != ".glb" && output.extension() != ".gltf") {
    throw Error(output.string(), ": got '", output.extension().string(),
                "', expected a file that ends in .glb or .gltf");
  }
  HandModel hand = load_hand(arguments.source);
  if (arguments.mirror) hand = mirrored(hand);
  write_whole(output, [&](const std::filesystem::path& file) { write_hand_gltf(hand, {}, file); });
  if (arguments.common.json) {
    std::cout << nlohmann::ordered_json{{"file", arguments.output},
                                        {"name", hand.name},
                                        {"side", side_name(hand.skeleton.side)},
                                        {"vertices", hand.rest_surface.vertices.size()}}
                     .dump()
              << "\n";
  } else {
    std::cout << fmt::format("wrote {}: a {} hand of {} vertices\n", arguments.output,
                             side_name(hand.skeleton.side), hand.rest_surface.vertices.size());
  }
}

}  // namespace hand_command

void add_hand_info_command(CLI::App& hand) {
  using namespace hand_command;
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command =
      hand.add_subcommand("info", "Say what a hand is: size, bones, limits, surface");
  add_hand_source(*command, arguments->source);
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata hand info --percentile 95 --sex male\n");
  command->callback([arguments] { run_info(*arguments); });
}

void add_hand_convert_command(CLI::App& hand) {
  using namespace hand_command;
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command =
      hand.add_subcommand("convert", "Write a hand as a skinned glTF with WebXR joint names");
  add_hand_source(*command, arguments->source);
  command->add_option("-o,--output", arguments->output, "GLB or glTF to write")->required();
  command->add_flag("--mirror", arguments->mirror, "Write the other hand: the mirror image");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata hand convert scan.toml -o hand.glb\n");
  command->callback([arguments] { run_convert(*arguments); });
}

void add_hand_command(CLI::App& program) {
  using namespace hand_command;
  CLI::App* hand =
      program.add_subcommand("hand", "Inspect, convert, pose, draw and personalise hands");
  hand->require_subcommand(1);
  hand->footer("Example: tegata hand info\n");
  add_hand_info_command(*hand);
  add_hand_convert_command(*hand);
  add_hand_pose_command(*hand);
  add_hand_picture_command(*hand);
  add_hand_personalise_command(*hand);
}

}  // namespace tegata
