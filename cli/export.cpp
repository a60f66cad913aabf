// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "tegata/export/export_result.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace export_command {

namespace fs = std::filesystem;

struct Arguments {
  std::string result, format, output, hand_file;
  ExportOptions options;
  bool force = false;
  CommonOptions common;
};

/// The hand that was fitted: it lies in the result, unless somebody took it away.
HandModel hand_of(const Arguments& arguments, const Result& result) {
  const fs::path file = fs::path(arguments.result) / "hand.glb";
  if (arguments.hand_file.empty() && fs::exists(file)) return read_hand_gltf(file, result.side);
  return scaled(load_hand(arguments.hand_file, result.side), result.model_scale);
}

void write_folder(const Export& exported, const Arguments& arguments) {
  StagedFolder folder(arguments.output, arguments.force, "hand.urdf");
  for (const ExportedFile& file : exported.files) {
    const fs::path path = folder.path() / file.name;
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    if (failure) throw Error(path.parent_path().string(), ": cannot be made: ", failure.message());
    write_file(path, file.content);
  }
  folder.commit();
}

void run(const Arguments& arguments) {
  const Result result = read_result_json(fs::path(arguments.result) / "result.json");
  const ExportFormat format = export_format_from_name(arguments.format);
  const Export exported =
      export_result(result, hand_of(arguments, result), format, arguments.options);
  if (format == ExportFormat::urdf) {
    write_folder(exported, arguments);
  } else {
    write_whole(arguments.output,
                [&](const fs::path& file) { write_file(file, exported.files.front().content); });
  }
  if (!arguments.common.quiet) {
    for (const std::string& note : exported.notes) {
      std::cerr << "tegata: warning: " << one_line(note) << "\n";
    }
  }
  if (arguments.common.json) {
    std::cout << nlohmann::ordered_json{{"output", arguments.output},
                                        {"format", arguments.format},
                                        {"frames", result.frames.size()},
                                        {"notes", exported.notes}}
                     .dump()
              << "\n";
  } else {
    std::cout << fmt::format("wrote {}: {} frames as {}\n", arguments.output, result.frames.size(),
                             arguments.format);
  }
}

}  // namespace export_command

void add_export_command(CLI::App& program) {
  using namespace export_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("export", "Write a result for robots, animation, OpenSim or NumPy");
  command->add_option("RESULT", arguments->result, "Folder that fit made")->required();
  command
      ->add_option("--to", arguments->format,
                   "urdf: a folder; bvh, csv, trc, mot, npz: a file (docs/formats.md)")
      ->check(CLI::IsMember({"urdf", "bvh", "csv", "trc", "mot", "npz"}))
      ->required();
  command->add_option("-o,--output", arguments->output, "File or folder to write")->required();
  command->add_option("--hand", arguments->hand_file,
                      "The hand that was fitted, as for fit; else the result's hand.glb");
  command
      ->add_option("--density", arguments->options.density,
                   "Of the hand, for a URDF's inertials [kg/m^3]")
      ->check(CLI::Range(1.0, 100000.0))
      ->capture_default_str();
  command->add_flag("--force", arguments->force, "Replace the folder of a URDF where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata export demo/result --to bvh -o demo/hand.bvh\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
