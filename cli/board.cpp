// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "tegata/calibrate/board_drawing.h"
#include "tegata/pipeline/calibrate_take.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace board_command {

struct Arguments {
  std::string board, output;
  bool force = false;
  CommonOptions common;
};

void run(const Arguments& arguments) {
  const BoardDrawing drawing = draw_board(read_board(arguments.board));
  check_free(arguments.output, arguments.force);
  write_whole(arguments.output,
              [&](const std::filesystem::path& file) { write_file(file, svg_of(drawing)); });
  const Eigen::Vector2d sheet = 1000.0 * drawing.sheet;
  if (arguments.common.json) {
    const nlohmann::ordered_json json = {{"board", arguments.output},
                                         {"size_mm", {sheet.x(), sheet.y()}}};
    std::cout << json.dump() << "\n";
    return;
  }
  std::cout << fmt::format(
      "{}: {:.1f} x {:.1f} mm; print it at 100 % and measure it: what counts is what was printed\n",
      arguments.output, sheet.x(), sheet.y());
}

}  // namespace board_command

void add_board_command(CLI::App& program) {
  using namespace board_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("board", "Draw a calibration board in its true size, as SVG");
  command->add_option("BOARD", arguments->board, "A board.toml")->required();
  command->add_option("-o,--output", arguments->output, "The SVG to write")->required();
  command->add_flag("--force", arguments->force, "Replace the file where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata board board_take/board.toml -o board.svg\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
