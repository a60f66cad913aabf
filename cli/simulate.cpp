// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "progress.h"
#include "tegata/sim/virtual_room.h"

namespace tegata {
namespace simulate_command {

struct Arguments {
  std::string take, grasp = "cylinder", mode = "infrared", hand = "right", side;
  bool no_forearm = false, no_initial_pose = false, force = false;
  SimulationOptions room;
  CommonOptions common;
};

void set_size(SimulationOptions& room, const std::string& size) {
  int width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(size.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 16 ||
      height < 16 || width > 16384 || height > 16384) {
    throw CLI::ValidationError("--size", "got '" + size + "', expected WIDTHxHEIGHT in pixels");
  }
  room.width = width;
  room.height = height;
}

HandModel hand_of(const Arguments& arguments) {
  std::optional<Side> side;
  if (!arguments.side.empty()) side = side_from_name(arguments.side);
  const bool is_file =
      arguments.hand != side_name(Side::right) && arguments.hand != side_name(Side::left);
  return is_file ? load_hand(arguments.hand, side) : load_hand("", side_from_name(arguments.hand));
}

void run(Arguments& arguments) {
  SimulationOptions& room = arguments.room;
  room.grasp = simulated_grasp_from_name(arguments.grasp);
  room.mode = simulated_mode_from_name(arguments.mode);
  const HandModel hand = hand_of(arguments);
  room.side = hand.skeleton.side;
  room.forearm = !arguments.no_forearm;
  room.initial_pose = !arguments.no_initial_pose;
  room.threads = arguments.common.threads;
  {
    Progress progress(arguments.common.quiet);
    simulate_take(hand, room, arguments.take, arguments.force, progress.observer());
  }
  if (arguments.common.json) {
    std::cout << nlohmann::ordered_json{{"take", arguments.take},
                                        {"cameras", room.camera_count},
                                        {"frames", room.frame_count},
                                        {"grasp", arguments.grasp},
                                        {"mode", arguments.mode},
                                        {"hand", side_name(room.side)},
                                        {"seed", room.seed}}
                     .dump()
              << "\n";
  } else {
    std::cout << fmt::format(
        "made {}: {} frames of {} cameras, {} hand, {} grasp; the truth is in truth.json and "
        "truth\n",
        arguments.take, room.frame_count, room.camera_count, side_name(room.side), arguments.grasp);
  }
}

}  // namespace simulate_command

void add_simulate_command(CLI::App& program) {
  using namespace simulate_command;
  const auto arguments = std::make_shared<Arguments>();
  SimulationOptions& room = arguments->room;
  CLI::App* command = program.add_subcommand(
      "simulate", "Make a take of a hand that turns an object in the virtual room");
  command->add_option("TAKE", arguments->take, "Folder to make")->required();
  command->add_option("--grasp", arguments->grasp, "What the hand does")
      ->check(CLI::IsMember({"cylinder", "sphere", "pinch", "lateral"}))
      ->capture_default_str();
  command
      ->add_option("--mode", arguments->mode,
                   "infrared pictures, or masks with or without "
                   "the object's pixels unknown")
      ->check(CLI::IsMember({"infrared", "mask", "clean"}))
      ->capture_default_str();
  command->add_option("--hand", arguments->hand, "right, left, or a hand's file (GLB, glTF, TOML)")
      ->capture_default_str();
  command->add_option("--side", arguments->side, "Which hand of a file; else the file's own")
      ->check(CLI::IsMember({"right", "left"}));
  command->add_option("--cameras", room.camera_count, "Cameras; 3 look along orthogonal axes")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  command->add_option("--frames", room.frame_count, "Frames")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--seed", room.seed, "Same seed, same take")->capture_default_str();
  command->add_option_function<std::string>(
      "--size", [arguments](const std::string& size) { set_size(arguments->room, size); },
      "WIDTHxHEIGHT of the pictures [640x480]");
  command->add_option("--bits", room.bits, "Bits of an infrared value")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str();
  command->add_option("--turn-deg", room.turn_deg, "Turn of the hand from frame to frame")
      ->check(CLI::Range(-180.0, 180.0))
      ->capture_default_str();
  command->add_flag("--no-forearm", arguments->no_forearm, "A hand without a warm forearm");
  command->add_flag("--no-initial-pose", arguments->no_initial_pose,
                    "No rough landmarks in take.toml");
  command->add_flag("--force", arguments->force, "Replace the folder where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata simulate demo/take --grasp cylinder --cameras 3 --frames 10\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
