// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>

#include "command.h"
#include "progress.h"
#include "tegata/base/text.h"
#include "tegata/experiment/accuracy.h"
#include "tegata/experiment/table1.h"
#include "tegata/experiment/table1_text.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace experiment_command {

namespace fs = std::filesystem;

struct Arguments {
  std::string folder;
  bool force = false;
  int seed_count = 0, frame_count = 0;
  std::vector<std::string> modes;  // none: all
  CommonOptions common;
};

/// What an experiment found, for people, for programs, and as further files by their names.
struct Found {
  std::string text, json;
  std::map<std::string, std::string> files;
};

Found table1(const Arguments& arguments, const fs::path& folder, const Observer& observer) {
  Table1Options options;
  options.seed_count = arguments.seed_count;
  options.frame_count = arguments.frame_count;
  options.threads = arguments.common.threads;
  options.folder = folder;
  const Table1 table = run_table1(options, observer);
  return {
      table1_text(table),
      table1_json(table),
      {{"weights.csv", weights_csv(table.weights)}, {"weights.svg", weights_svg(table.weights)}}};
}

Found accuracy(const Arguments& arguments, const fs::path& folder, const Observer& observer) {
  AccuracyOptions options;
  options.seed_count = arguments.seed_count;
  options.frame_count = arguments.frame_count;
  options.threads = arguments.common.threads;
  options.folder = folder;
  if (!arguments.modes.empty()) options.modes.clear();
  for (const std::string& mode : arguments.modes) {
    options.modes.push_back(simulated_mode_from_name(mode));
  }
  const Accuracy found = run_accuracy(options, observer);
  return {accuracy_text(found), accuracy_json(found), {}};
}

using Experiment = Found (*)(const Arguments&, const fs::path&, const Observer&);

void run(const std::string& name, Experiment experiment, const Arguments& arguments) {
  // Without a folder to keep, the takes lie in one that is never put in its place.
  const bool is_kept = !arguments.folder.empty();
  const std::string json_file = name + ".json";
  StagedFolder folder(is_kept ? fs::path(arguments.folder)
                              : fs::temp_directory_path() / text("tegata-", name, "-", getpid()),
                      arguments.force, json_file);
  Found found;
  {
    Progress progress(arguments.common.quiet);
    found = experiment(arguments, folder.path(), progress.observer());
  }
  if (is_kept) {
    write_file(folder.path() / (name + ".txt"), found.text);
    write_file(folder.path() / json_file, found.json);
    for (const auto& [file, content] : found.files) write_file(folder.path() / file, content);
    folder.commit();
  }
  std::cout << (arguments.common.json ? found.json : found.text);
}

CLI::App* add_experiment(CLI::App& group, const std::string& name, const std::string& what,
                         Experiment experiment, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command = group.add_subcommand(name, what);
  command->add_option("--seeds", arguments->seed_count, "Takes of each grasp")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--frames", arguments->frame_count, "Of each take")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->folder,
                      "Folder to make, with the figures as text and JSON");
  command->add_flag("--force", arguments->force, "Replace the folder where it exists");
  add_common_options(*command, arguments->common);
  command->callback([=] { run(name, experiment, *arguments); });
  return command;
}

}  // namespace experiment_command

void add_experiment_command(CLI::App& program) {
  using namespace experiment_command;
  CLI::App* group = program.add_subcommand("experiment", "Measure errors in the virtual room");
  group->require_subcommand(1);
  const auto of_table = std::make_shared<Arguments>();
  of_table->seed_count = 10;
  of_table->frame_count = 5;
  add_experiment(*group, "table1",
                 "Table I of Ogawara et al. 2003: three grasps, the paper's method and the default",
                 table1, of_table)
      ->footer(
          "The folder also gets the weights as CSV and SVG.\n"
          "Example: tegata experiment table1 --seeds 3 -o table1\n");
  const auto of_suite = std::make_shared<Arguments>();
  of_suite->seed_count = 5;
  of_suite->frame_count = 10;
  CLI::App* suite = add_experiment(
      *group, "accuracy",
      "The default method: three grasps, object unseen, marked as unknown, or absent", accuracy,
      of_suite);
  suite->add_option("--mode", of_suite->modes, "Only infrared, mask or clean takes")
      ->check(CLI::IsMember({"infrared", "mask", "clean"}));
  suite->footer("Example: tegata experiment accuracy --mode clean --seeds 1 -o accuracy\n");
}

}  // namespace tegata
