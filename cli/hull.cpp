// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "command.h"
#include "progress.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/pipeline/hull_take.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace hull_command {

constexpr const char* kSummaryFile = "hulls.json";

struct Arguments {
  std::string take, folder;
  bool force = false;
  std::size_t triangle_count = 0;  ///< 0: usual_triangle_count()
  HullTakeOptions options;
  CommonOptions common;
};

/// 4000 at the usual voxel, for finer ones more, as the surface asks for.
std::size_t usual_triangle_count(double voxel_size) {
  const HullOptions usual;
  const double finer = std::max(1.0, usual.voxel_size / voxel_size);
  return static_cast<std::size_t>(static_cast<double>(usual.triangle_count) * finer * finer);
}

nlohmann::ordered_json describe(const TakeHull& hull) {
  const HullReport& report = hull.report;
  nlohmann::ordered_json json;
  json["name"] = hull.frame;
  json["status"] = hull.refusal.empty() ? "ok" : hull.refusal;
  if (!hull.refusal.empty()) return json;
  json["file"] = hull.frame + ".ply";
  json["triangles"] = report.triangle_count;
  json["triangles_before_simplification"] = report.raw_triangle_count;
  json["volume_cm3"] = 1e6 * report.volume;
  json["silhouette_iou"] = hull.overlaps;
  for (const SparseField::Level& level : report.levels) {
    json["levels"].push_back(
        {{"visited", level.visited}, {"inside", level.inside}, {"outside", level.outside}});
  }
  json["milliseconds"] = {{"segment", 1e3 * hull.segment_seconds},
                          {"region", 1e3 * report.region_seconds},
                          {"carve", 1e3 * report.carve_seconds},
                          {"isosurface", 1e3 * report.isosurface_seconds},
                          {"simplify", 1e3 * report.simplify_seconds}};
  return json;
}

/// One line a frame.
void print_frames(const nlohmann::ordered_json& frames) {
  std::cout << fmt::format("{:<12} {:>9} {:>10}   {:>7} {:>6} {:>6} {:>10} {:>8}   {}\n", "frame",
                           "triangles", "volume_cm3", "segment", "region", "carve", "isosurface",
                           "simplify", "overlap with the silhouettes (times in ms)");
  for (const auto& frame : frames) {
    const std::string name = frame["name"], status = frame["status"];
    if (status != "ok") {
      std::cout << fmt::format("{:<12} {}\n", name, status);
      continue;
    }
    const auto& ms = frame["milliseconds"];
    const std::map<std::string, double> overlaps = frame["silhouette_iou"];
    std::string line;
    for (const auto& [camera, overlap] : overlaps) {
      line += fmt::format("{}{} {:.3f}", line.empty() ? "" : ", ", camera, overlap);
    }
    std::cout << fmt::format(
        "{:<12} {:>9} {:>10.1f}   {:>7.1f} {:>6.1f} {:>6.1f} {:>10.1f} {:>8.1f}   {}\n", name,
        frame["triangles"].get<std::size_t>(), frame["volume_cm3"].get<double>(),
        ms["segment"].get<double>(), ms["region"].get<double>(), ms["carve"].get<double>(),
        ms["isosurface"].get<double>(), ms["simplify"].get<double>(), line);
  }
}

/// The nodes of the first hull's octree; those of the other frames are much the same.
void print_levels(const nlohmann::ordered_json& frames, double voxel_size) {
  const auto first = std::find_if(frames.begin(), frames.end(),
                                  [](const auto& frame) { return frame["status"] == "ok"; });
  if (first == frames.end()) return;
  const auto& levels = (*first)["levels"];
  std::cout << fmt::format("octree of frame {}:\n{:>9} {:>9} {:>9} {:>9} {:>9}\n",
                           (*first)["name"].get<std::string>(), "cell_mm", "nodes", "inside",
                           "outside", "split");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::size_t visited = levels[i]["visited"], inside = levels[i]["inside"],
                      outside = levels[i]["outside"];
    const double cell_mm =
        1e3 * voxel_size * static_cast<double>(std::size_t{1} << (levels.size() - 1 - i));
    const bool is_finest = i + 1 == levels.size();
    std::cout << fmt::format("{:>9.4g} {:>9} {:>9} {:>9} {:>9}{}\n", cell_mm, visited, inside,
                             outside, visited - inside - outside, is_finest ? " leaves" : "");
  }
}

void run(Arguments& arguments) {
  Take take = Take::open(arguments.take);
  StagedFolder folder(arguments.folder, arguments.force, kSummaryFile);
  arguments.options.threads = arguments.common.threads;
  if (arguments.triangle_count > 0) {
    arguments.options.hull.triangle_count = arguments.triangle_count;
  } else {
    arguments.options.hull.triangle_count = usual_triangle_count(arguments.options.hull.voxel_size);
  }

  nlohmann::ordered_json summary;
  summary["format"] = "tegata-hulls";
  summary["version"] = 1;
  summary["take"] = take.info().name;
  summary["voxel_mm"] = 1e3 * arguments.options.hull.voxel_size;
  summary["frames"] = nlohmann::ordered_json::array();
  std::size_t made = 0;
  {
    Progress progress(arguments.common.quiet);
    const auto keep = [&](const TakeHull& hull) {
      summary["frames"].push_back(describe(hull));
      if (!hull.refusal.empty()) return;
      write_ply(hull.mesh, folder.path() / (hull.frame + ".ply"));
      ++made;
    };
    hull_take(take, arguments.options, keep, progress.observer());
  }
  const nlohmann::ordered_json& frames = summary["frames"];
  if (made == 0) {
    throw Error(arguments.take, ": none of ", frames.size(), " frames has a hull; the first, ",
                frames[0]["name"].get<std::string>(), ": ", frames[0]["status"].get<std::string>());
  }
  write_file(folder.path() / kSummaryFile, summary.dump(1) + "\n");
  folder.commit();
  if (arguments.common.json) {
    std::cout << summary.dump() << "\n";
    return;
  }
  print_frames(frames);
  print_levels(frames, arguments.options.hull.voxel_size);
  std::cout << fmt::format("{} of {} hulls in {}\n", made, frames.size(), arguments.folder);
}

}  // namespace hull_command

void add_hull_command(CLI::App& program) {
  using namespace hull_command;
  const auto arguments = std::make_shared<Arguments>();
  HullTakeOptions& options = arguments->options;
  CLI::App* command = program.add_subcommand("hull", "Visual hulls of a take, without a hand");
  command->add_option("TAKE", arguments->take, "Folder with calibration.toml and pictures")
      ->required();
  command->add_option("-o,--output", arguments->folder, "Folder to make")->required();
  add_frames_option(*command, options.frames);
  add_segmentation_option(*command, options.segmentation);
  add_voxel_option(*command, options.hull);
  command
      ->add_option("--triangles", arguments->triangle_count,
                   "Of each simplified hull; else 4000, and more for voxels below 2 mm")
      ->check(CLI::Range(100, 10000000));
  command
      ->add_option("--dissenting-views", options.hull.dissenting_views,
                   "A point survives so many views that see background there")
      ->check(CLI::Range(0, 15))
      ->capture_default_str();
  command->add_flag("--force", arguments->force, "Replace the folder where it exists");
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata hull demo/take -o demo/hulls --voxel-mm 2\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata
