// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "hand_command.h"
#include "progress.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/pipeline/personalise.h"
#include "tegata/take/hand_shape_file.h"

namespace tegata {
namespace hand_personalise_command {

struct Arguments {
  std::vector<std::string> takes;
  std::string output, side, name, grasp = "fixed";
  PersonaliseOptions options;
  CommonOptions common;
};

/// The one side of all takes.
Side side_of(const std::vector<Take>& takes, const std::string& asked) {
  const Side side = choose_side(takes.front(), asked);
  for (const Take& take : takes) {
    if (choose_side(take, asked) != side) {
      throw Error(take.folder().string(), ": it shows a ", side_name(choose_side(take, asked)),
                  " hand, ", takes.front().folder().string(), " a ", side_name(side),
                  " one; expected takes of one hand");
    }
  }
  return side;
}

void write_hand(const HandShapeFile& hand, const std::filesystem::path& output) {
  write_whole(output, [&](const std::filesystem::path& file) {
    if (output.extension() == ".toml") {
      write_hand_shape(hand, file);
    } else {
      HandModel model = built_in_hand(shape_from_parameters(hand.parameters), hand.side);
      model.name = hand.name;
      write_hand_gltf(model, {}, file);
    }
  });
}

void print_json(const Arguments& arguments, const HandShapeFile& hand, const PersonalHand& person) {
  nlohmann::ordered_json json;
  json["file"] = arguments.output;
  json["name"] = hand.name;
  json["side"] = side_name(hand.side);
  json["frames"] = person.frame_count;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    json["shape"][shape_parameter_names()[static_cast<std::size_t>(i)]] = {
        {"value", hand.parameters[i]},
        {"standard_deviation", (*hand.standard_deviations)[i]},
        {"prior", shape_prior().mean[i]},
        {"prior_standard_deviation", shape_prior().deviation[i]}};
  }
  json["scale"] = person.scale.scale;
  json["iterations"] = person.fit.iterations;
  json["termination"] = termination_name(person.fit.termination);
  json["seconds"] = person.seconds;
  std::cout << json.dump() << "\n";
}

void print_table(const Arguments& arguments, const HandShapeFile& hand,
                 const PersonalHand& person) {
  std::cout << fmt::format("{:<26} {:>8} {:>8}   {:>8} {:>8}\n", "parameter", "value", "sd",
                           "adults", "sd");
  for (int i = 0; i < kShapeParameterCount; ++i) {
    const std::string& name = shape_parameter_names()[static_cast<std::size_t>(i)];
    const bool is_length = i == 0;
    const double unit = is_length ? 1e3 : 1.0;
    std::cout << fmt::format("{0:<26} {2:8.{1}f} {3:8.{1}f}   {4:8.{1}f} {5:8.{1}f}\n",
                             name + (is_length ? " [mm]" : ""), is_length ? 1 : 3,
                             unit * hand.parameters[i], unit * (*hand.standard_deviations)[i],
                             unit * shape_prior().mean[i], unit * shape_prior().deviation[i]);
  }
  std::cout << fmt::format(
      "wrote {}: a {} hand, from {} frames after {:.1f} s; the fit ended with: {}\n",
      arguments.output, side_name(hand.side), person.frame_count, person.seconds,
      termination_name(person.fit.termination));
}

void run(Arguments& arguments) {
  const std::filesystem::path output = arguments.output;
  if (output.extension() != ".glb" && output.extension() != ".gltf" &&
      output.extension() != ".toml") {
    throw Error(output.string(), ": got '", output.extension().string(),
                "', expected a file that ends in .glb, .gltf or .toml");
  }
  const std::filesystem::path folder_of_output =
      output.has_parent_path() ? output.parent_path() : ".";
  if (!std::filesystem::is_directory(folder_of_output)) {
    throw Error(output.string(), ": there is no folder ", folder_of_output.string(),
                ", expected one to write to");
  }
  std::vector<Take> takes;
  for (const std::string& folder : arguments.takes) takes.push_back(Take::open(folder));
  HandShapeFile hand;
  hand.name = arguments.name.empty() ? output.stem().string() : arguments.name;
  hand.side = side_of(takes, arguments.side);
  arguments.options.threads = arguments.common.threads;
  arguments.options.scratch_folder = folder_of_output;
  arguments.options.fit.grasp = grasp_constraint_from_name(arguments.grasp);
  PersonalHand person;
  {
    Progress progress(arguments.common.quiet);
    person = personalise(takes, hand.side, arguments.options, progress.observer());
  }
  hand.parameters = person.fit.shape;
  hand.standard_deviations = person.fit.standard_deviations;
  write_hand(hand, output);
  if (arguments.common.json) {
    print_json(arguments, hand, person);
  } else {
    print_table(arguments, hand, person);
  }
}

}  // namespace hand_personalise_command

void add_hand_personalise_command(CLI::App& hand) {
  using namespace hand_personalise_command;
  const auto arguments = std::make_shared<Arguments>();
  PersonaliseOptions& options = arguments->options;
  CLI::App* command = hand.add_subcommand(
      "personalise", "Estimate somebody's hand from takes of it: sizes with standard deviations");
  command
      ->add_option("TAKE", arguments->takes,
                   "Takes of one hand; an open hand that turns tells most, any grasp will do")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "The hand to write: skinned (GLB, glTF), or its sizes (TOML)")
      ->required();
  command->add_option("--name", arguments->name, "What to call it; else the file's name");
  command->add_option("--side", arguments->side, "Which hand, where the takes do not say")
      ->check(CLI::IsMember({"right", "left"}));
  add_segmentation_option(*command, options.segmentation);
  add_grasp_option(*command, arguments->grasp);
  add_frames_option(*command, options.frames);
  add_voxel_option(*command, options.hull);
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata hand personalise open-hand mug-03 -o anna.toml\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
