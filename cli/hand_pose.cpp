// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "hand_command.h"
#include "hand_view.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/image/overlay.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/picture_file.h"

namespace tegata {
namespace hand_pose_command {

struct PoseArguments {
  HandSource source;
  AngleSource angles;
  std::string output;
  CommonOptions common;
};

struct PictureArguments {
  HandSource source;
  AngleSource angles;
  std::string output;
  std::vector<std::string> views = {"back", "palm", "thumb", "tips"};
  int width = 320;
  CommonOptions common;
};

void write_posed(const HandModel& hand, const HandPose& pose, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".ply") {
    write_ply(PosedHand(hand, pose).surface(), file);
  } else if (ending == ".obj") {
    write_obj(PosedHand(hand, pose).surface(), file);
  } else if (ending == ".glb" || ending == ".gltf") {
    write_hand_gltf(hand, {{0.0, pose}}, file);
  } else {
    throw Error(file.string(), ": got '", ending, "', expected .ply, .obj, .glb or .gltf");
  }
}

void run_pose(const PoseArguments& arguments) {
  const HandModel hand = load_hand(arguments.source, arguments.angles);
  const HandPose pose = pose_of(arguments.angles, hand);
  if (!arguments.common.quiet) warn_of_limits(pose.angles);
  write_whole(arguments.output,
              [&](const std::filesystem::path& file) { write_posed(hand, pose, file); });
  if (arguments.common.json) {
    nlohmann::ordered_json json{{"file", arguments.output}, {"name", hand.name}};
    for (int angle = 0; angle < kAngleCount; ++angle) {
      json["angles"][std::string(angle_names()[static_cast<std::size_t>(angle)])] =
          pose.angles[angle];
    }
    std::cout << json.dump() << "\n";
  } else {
    std::cout << "wrote " << arguments.output << "\n";
  }
}

View view_of(const std::string& name, Side side) {
  const Eigen::Vector3d thumb =
      side == Side::right ? -Eigen::Vector3d::UnitX().eval() : Eigen::Vector3d::UnitX().eval();
  if (name == "back") return {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
  if (name == "palm") return {-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
  if (name == "thumb") return {thumb, Eigen::Vector3d::UnitY()};
  if (name == "little") return {-thumb, Eigen::Vector3d::UnitY()};
  return {Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};  // tips
}

CameraImage draw(const HandModel& hand, const JointAngles& angles,
                 const PictureArguments& arguments) {
  const TriangleMesh surface = PosedHand(hand, {Rigid3d(), angles}).surface();
  const Ball ball = ball_around(surface);
  std::vector<CameraImage> pictures;
  for (const std::string& name : arguments.views) {
    pictures.push_back(
        draw_hand(surface, view_of(name, hand.skeleton.side), ball, arguments.width));
  }
  return contact_sheet(pictures, static_cast<int>(pictures.size()), kPaper);
}

void run_picture(const PictureArguments& arguments) {
  const HandModel hand = load_hand(arguments.source, arguments.angles);
  const HandPose pose = pose_of(arguments.angles, hand);
  if (!arguments.common.quiet) warn_of_limits(pose.angles);
  const CameraImage picture = draw(hand, pose.angles, arguments);
  write_whole(arguments.output,
              [&](const std::filesystem::path& file) { write_picture(picture, file); });
  if (arguments.common.json) {
    std::cout
        << nlohmann::ordered_json{{"picture", arguments.output}, {"views", arguments.views}}.dump()
        << "\n";
  } else {
    std::cout << "drew " << arguments.output << "\n";
  }
}

}  // namespace hand_pose_command

void add_hand_pose_command(CLI::App& hand) {
  using namespace hand_pose_command;
  const auto arguments = std::make_shared<PoseArguments>();
  CLI::App* command = hand.add_subcommand(
      "pose", "Bend a hand: its surface as PLY or OBJ, or GLB with the pose as an animation");
  add_hand_source(*command, arguments->source);
  add_angle_source(*command, arguments->angles);
  command->add_option("-o,--output", arguments->output, "PLY, OBJ, GLB or glTF to write")
      ->required();
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata hand pose --angle index_pip_flexion=60 -o hand.ply\n");
  command->callback([arguments] { run_pose(*arguments); });
}

void add_hand_picture_command(CLI::App& hand) {
  using namespace hand_pose_command;
  const auto arguments = std::make_shared<PictureArguments>();
  CLI::App* command = hand.add_subcommand("picture", "Draw a hand from several sides");
  add_hand_source(*command, arguments->source);
  add_angle_source(*command, arguments->angles);
  command->add_option("-o,--output", arguments->output, "PNG, JPEG or TIFF to write")->required();
  command->add_option("--views", arguments->views, "Sides to draw, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember({"back", "palm", "thumb", "little", "tips"}))
      ->capture_default_str();
  command->add_option("--width", arguments->width, "Pixels of a view in width")
      ->check(CLI::Range(16, 4096))
      ->capture_default_str();
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata hand picture --from relaxed -o hand.png\n");
  command->callback([arguments] { run_picture(*arguments); });
}

}  // namespace tegata
