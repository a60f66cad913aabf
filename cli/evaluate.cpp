// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/evaluate/evaluation.h"

#include <iostream>
#include <memory>

#include "command.h"

namespace tegata {
namespace evaluate_command {

struct Arguments {
  std::string result, truth;
  CommonOptions common;
};

void run(const Arguments& arguments) {
  const Evaluation evaluation =
      evaluate_result(arguments.result, arguments.truth, arguments.common.threads);
  const std::string out =
      arguments.common.json ? evaluation_json(evaluation) : evaluation_table(evaluation);
  std::cout << out << (out.ends_with('\n') ? "" : "\n");
}

}  // namespace evaluate_command

void add_evaluate_command(CLI::App& program) {
  using namespace evaluate_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("evaluate", "Compare a result with the truth");
  command->add_option("RESULT", arguments->result, "Folder that fit made")->required();
  command->add_option("--truth", arguments->truth, "Folder with truth.json and truth/")->required();
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata evaluate demo/result --truth demo/take\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
