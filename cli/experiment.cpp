// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "command.h"
#include "progress.h"
#include "tegata/base/text.h"
#include "tegata/experiment/table1.h"
#include "tegata/experiment/table1_text.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string folder;
  bool force = false;
  Table1Options options;
  CommonOptions common;
};

void run(Arguments& arguments) {
  // Without a folder to keep, the takes lie in one that is never put in its place.
  const bool is_kept = !arguments.folder.empty();
  StagedFolder folder(is_kept ? fs::path(arguments.folder)
                              : fs::temp_directory_path() / text("tegata-table1-", getpid()),
                      arguments.force, "table1.json");
  arguments.options.threads = arguments.common.threads;
  arguments.options.folder = folder.path();
  Table1 table;
  {
    Progress progress(arguments.common.quiet);
    table = run_table1(arguments.options, progress.observer());
  }
  if (is_kept) {
    write_file(folder.path() / "table1.txt", table1_text(table));
    write_file(folder.path() / "table1.json", table1_json(table));
    write_file(folder.path() / "weights.csv", weights_csv(table.weights));
    write_file(folder.path() / "weights.svg", weights_svg(table.weights));
    folder.commit();
  }
  std::cout << (arguments.common.json ? table1_json(table) : table1_text(table));
}

}  // namespace

void add_experiment_command(CLI::App& program) {
  CLI::App* group = program.add_subcommand("experiment", "Repeat a published experiment");
  group->require_subcommand(1);
  const auto arguments = std::make_shared<Arguments>();
  Table1Options& options = arguments->options;
  CLI::App* command = group->add_subcommand(
      "table1", "Table I of Ogawara et al. 2003: three grasps, the paper's method and the default");
  command->add_option("--seeds", options.seed_count, "Takes of each grasp")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--frames", options.frame_count, "Of each take")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->folder,
                      "Folder to make, with the table and the weights as CSV and SVG");
  command->add_flag("--force", arguments->force, "Replace the folder where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata experiment table1 --seeds 3 -o table1\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
