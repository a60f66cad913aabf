// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "progress.h"
#include "tegata/pipeline/segment_take.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace segment_command {

constexpr const char* kSummaryFile = "silhouettes.json";
constexpr const char* kSheetFile = "contact_sheet.png";

struct Arguments {
  std::string take, folder;
  bool force = false;
  SegmentTakeOptions options;
  CommonOptions common;
};

nlohmann::ordered_json describe(const Take& take, const SegmentedTake& segmented) {
  nlohmann::ordered_json json;
  json["format"] = "tegata-silhouettes";
  json["version"] = 1;
  json["take"] = take.info().name;
  json["method"] = segmentation_method_name(segmented.method);
  json["frames"] = nlohmann::ordered_json::array();
  for (const SegmentedFrame& frame : segmented.frames) {
    auto views = nlohmann::ordered_json::object();
    for (const SegmentedView& view : frame.views) {
      views[view.camera] = {{"hand_pixels", view.hand_pixels}, {"confidence", view.confidence}};
    }
    json["frames"].push_back({{"frame", frame.name}, {"views", views}});
    if (!frame.left_out.empty()) json["frames"].back()["left_out"] = frame.left_out;
  }
  return json;
}

/// How many views show a hand, and which is the least sure of these.
std::string summary(const SegmentedTake& segmented) {
  std::size_t count = 0, found = 0;
  double least = 2.0;
  std::string where;
  for (const SegmentedFrame& frame : segmented.frames) {
    for (const SegmentedView& view : frame.views) {
      ++count;
      if (view.hand_pixels == 0) continue;
      ++found;
      if (view.confidence >= least) continue;
      least = view.confidence;
      where = fmt::format("frame {}, camera {}", frame.name, view.camera);
    }
  }
  std::string line =
      fmt::format("{} frames by {}: a hand in {} of {} pictures", segmented.frames.size(),
                  segmentation_method_name(segmented.method), found, count);
  if (found > 0) line += fmt::format("; least sure is {}: {:.2f}", where, least);
  return line;
}

void run(Arguments& arguments) {
  Take take = Take::open(arguments.take);
  StagedFolder folder(arguments.folder, arguments.force, kSummaryFile);
  arguments.options.threads = arguments.common.threads;
  SegmentedTake segmented;
  {
    Progress progress(arguments.common.quiet);
    segmented = segment_take(take, folder.path(), arguments.options, progress.observer());
  }
  const nlohmann::ordered_json json = describe(take, segmented);
  write_file(folder.path() / kSummaryFile, json.dump(1) + "\n");
  write_picture(segmented.contact_sheet, folder.path() / kSheetFile);
  folder.commit();
  if (arguments.common.json) {
    std::cout << json.dump() << "\n";
    return;
  }
  LeftOut left_out;
  for (const SegmentedFrame& frame : segmented.frames) left_out.add(frame.name, frame.left_out);
  std::cout << summary(segmented) << "\n" << left_out.lines();
  std::cout << fmt::format("look at {} before fitting {}\n",
                           (std::filesystem::path(arguments.folder) / kSheetFile).string(),
                           arguments.folder);
}

}  // namespace segment_command

void add_segment_command(CLI::App& program) {
  using namespace segment_command;
  const auto arguments = std::make_shared<Arguments>();
  SegmentTakeOptions& options = arguments->options;
  CLI::App* command =
      program.add_subcommand("segment", "Make a take of masks, with a picture of what was cut out");
  command->add_option("TAKE", arguments->take, "Folder with calibration.toml and pictures")
      ->required();
  command->add_option("-o,--output", arguments->folder, "Folder to make, a take of masks")
      ->required();
  add_frames_option(*command, options.frames);
  add_segmentation_option(*command, options.segmentation, "--method,--segmentation");
  command->add_option("--sheet-rows", options.sheet_rows, "Frames on the contact sheet")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--force", arguments->force, "Replace the folder where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata segment demo/take -o demo/masks\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
