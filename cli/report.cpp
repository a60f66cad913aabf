// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "command.h"
#include "progress.h"
#include "tegata/export/report_page.h"
#include "tegata/export/viewer_page.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/pipeline/hull_take.h"
#include "tegata/pipeline/silhouettes.h"

namespace tegata {
namespace report_command {

namespace fs = std::filesystem;

struct Arguments {
  std::string result, take, hand_file, page;
  std::optional<SegmentationMethod> segmentation;
  CommonOptions common;
};

/// The frames of a result whose hulls its page can carry.
std::set<std::string> wanted_hulls(const Result& result) {
  std::vector<std::string> frames;
  for (const ResultFrame& frame : result.frames) frames.push_back(frame.name);
  return frames_with_hull(frames);
}

/// The hulls that fit wrote with --hulls.
std::map<std::string, TriangleMesh> written_hulls(const fs::path& folder, const Result& result) {
  std::map<std::string, TriangleMesh> hulls;
  for (const std::string& frame : wanted_hulls(result)) {
    const fs::path file = folder / (frame + ".ply");
    if (fs::exists(file)) hulls[frame] = report_hull(read_ply(file), result.frames.size());
  }
  return hulls;
}

/// The frames of a take that a result has, and perhaps some between them.
FrameSelection frames_of(const Result& result, const Take& take) {
  std::map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < take.frame_names().size(); ++i) index_of[take.frame_names()[i]] = i;
  std::vector<std::size_t> indices;
  for (const ResultFrame& frame : result.frames) {
    const auto found = index_of.find(frame.name);
    if (found != index_of.end()) indices.push_back(found->second);
  }
  if (indices.empty()) return {};
  std::sort(indices.begin(), indices.end());
  FrameSelection frames{indices.front(), indices.back(), 0};
  for (const std::size_t index : indices) {
    frames.step = std::gcd(frames.step, index - indices.front());
  }
  frames.step = std::max<std::size_t>(1, frames.step);
  return frames;
}

std::map<std::string, TriangleMesh> carved_hulls(Take& take, const Result& result,
                                                 const Arguments& arguments,
                                                 const Observer& observer) {
  HullTakeOptions options;
  options.frames = frames_of(result, take);
  options.segmentation = arguments.segmentation;
  options.threads = arguments.common.threads;
  const std::set<std::string> wanted = wanted_hulls(result);
  std::map<std::string, TriangleMesh> hulls;
  hull_take(
      take, options,
      [&](const TakeHull& hull) {
        if (hull.refusal.empty() && wanted.contains(hull.frame)) {
          hulls[hull.frame] = report_hull(hull.mesh, result.frames.size());
        }
      },
      observer);
  return hulls;
}

void run(const Arguments& arguments) {
  require_viewer_page();
  const fs::path folder = arguments.result;
  const Result result = read_result_json(folder / "result.json");
  const HandModel hand = scaled(load_hand(arguments.hand_file, result.side), result.model_scale);
  if (hand.name != result.model_name) {
    throw Error(arguments.result, ": was fitted with the hand '", result.model_name, "', got '",
                hand.name, "'; give that hand's file with --hand");
  }
  const fs::path page = arguments.page.empty() ? folder / "report.html" : fs::path(arguments.page);
  std::optional<Take> take;
  if (!arguments.take.empty()) take = Take::open(arguments.take);
  {
    Progress progress(arguments.common.quiet);
    // What there is to warn of was said when the frames were fitted.
    Observer observer = progress.observer();
    observer.on_warning = nullptr;
    ReportSource source{.take = take ? &*take : nullptr,
                        .segmentation = arguments.segmentation,
                        .hulls = written_hulls(folder / "hulls", result),
                        .threads = arguments.common.threads};
    if (take && source.hulls.empty()) {
      source.hulls = carved_hulls(*take, result, arguments, observer);
    }
    write_report(result, hand, std::move(source), page, observer);
  }
  if (arguments.common.json) {
    std::cout
        << nlohmann::ordered_json{{"report", page.string()}, {"bytes", fs::file_size(page)}}.dump()
        << "\n";
  } else {
    std::cout << fmt::format("wrote {}, {:.1f} MB\n", page.string(),
                             1e-6 * static_cast<double>(fs::file_size(page)));
  }
}

}  // namespace report_command

void write_report(const Result& result, const HandModel& hand, ReportSource source,
                  const std::filesystem::path& file, const Observer& observer) {
  ReportContent content{result, hand, {}, {}, std::move(source.hulls)};
  if (source.take != nullptr) {
    Take& take = *source.take;
    const Segmenter segmenter(take, source.segmentation, observer);
    const auto segment = [&](const TakeFrame& frame) { return segmenter.segment(frame); };
    content.rig = take.rig();
    content.pictures =
        make_report_pictures(take, result, hand, segment, {.threads = source.threads}, observer);
  }
  write_report_page(content, file);
}

void add_report_command(CLI::App& program) {
  using namespace report_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "report", "Make the report page of a result anew: one file for any browser");
  command->add_option("RESULT", arguments->result, "Folder that fit made")->required();
  command->add_option("--take", arguments->take,
                      "The take that was fitted; without it there are no pictures");
  command->add_option("-o,--output", arguments->page, "Page to write; else RESULT/report.html");
  command->add_option("--hand", arguments->hand_file, "The hand that was fitted, as for fit");
  add_segmentation_option(*command, arguments->segmentation);
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata report demo/result --take demo/take\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
