// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "command.h"

// Exit codes: 0 done, 1 an error that one line on stderr explains, 2 wrong usage.
int main(int argc, char** argv) {
  // FFmpeg prints of its own what is wrong with a video; which pictures it cost is said anyway.
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  CLI::App program("From a few calibrated cameras to the pose, joint angles and grasp of a hand.",
                   "tegata");
  program.set_version_flag("--version", "tegata " TEGATA_VERSION);
  program.require_subcommand(1);
  program.footer("Each command explains itself: tegata fit --help\n");
  tegata::add_simulate_command(program);
  tegata::add_fit_command(program);
  tegata::add_evaluate_command(program);
  tegata::add_experiment_command(program);
  tegata::add_export_command(program);
  tegata::add_info_command(program);
  tegata::add_picture_command(program);
  tegata::add_hull_command(program);
  tegata::add_hand_command(program);
  tegata::add_calibration_command(program);
  tegata::add_calibrate_command(program);
  tegata::add_board_command(program);
  tegata::add_segment_command(program);
  tegata::add_report_command(program);
  tegata::add_view_command(program);
  try {
    program.parse(argc, argv);
    std::cout.flush();
    if (!std::cout) throw tegata::Error("standard output: cannot be written");
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "tegata: error: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
