// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "command.h"

#include <fmt/format.h>

#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/built_in_hand.h"

namespace tegata {

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "Threads to use; 0: one per core")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--json", options.json, "Print one JSON object for scripts");
  command.add_flag("--quiet,-q", options.quiet, "No progress and no warnings, errors only");
}

Side side_from_name(const std::string& name) {
  for (const Side side : {Side::right, Side::left}) {
    if (name == side_name(side)) return side;
  }
  throw Error("hand: got '", name, "', expected right or left");
}

HandModel load_hand(const std::string& file, Side side) {
  return file.empty() ? built_in_hand(HandShape{}, side) : read_hand_gltf(file, side);
}

std::map<std::string, double> mean_overlaps(const Result& result) {
  std::map<std::string, double> sums;
  std::map<std::string, int> counts;
  for (const ResultFrame& frame : result.frames) {
    if (frame.status != "ok") continue;
    for (const auto& [camera, overlap] : frame.silhouette_iou) {
      sums[camera] += overlap;
      ++counts[camera];
    }
  }
  for (auto& [camera, sum] : sums) sum /= counts[camera];
  return sums;
}

std::map<std::string, int> count_statuses(const Result& result) {
  std::map<std::string, int> counts;
  for (const ResultFrame& frame : result.frames) ++counts[frame.status];
  return counts;
}

std::string overlap_text(const std::map<std::string, double>& overlaps) {
  std::string line;
  for (const auto& [camera, overlap] : overlaps) {
    line += fmt::format("{}{} {:.2f}", line.empty() ? "" : ", ", camera, overlap);
  }
  return line;
}

}  // namespace tegata
