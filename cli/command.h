// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What the subcommands share. Each of them is one file that declares its options, calls the library
// and prints; tegata::Error goes through to main.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/hand/hand_model.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/pipeline/frame_selection.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

void add_simulate_command(CLI::App& program);
void add_fit_command(CLI::App& program);
void add_evaluate_command(CLI::App& program);
void add_experiment_command(CLI::App& program);
void add_export_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_picture_command(CLI::App& program);
void add_hull_command(CLI::App& program);
void add_hand_command(CLI::App& program);
void add_calibration_command(CLI::App& program);
void add_calibrate_command(CLI::App& program);
void add_board_command(CLI::App& program);
void add_segment_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_view_command(CLI::App& program);

/// What every subcommand understands.
struct CommonOptions {
  int threads = 0;     ///< 0: one per core
  bool json = false;   ///< one JSON object on stdout instead of text
  bool quiet = false;  ///< nothing but errors on stderr
};
void add_common_options(CLI::App& command, CommonOptions& options);

/// --frames FIRST:LAST:STEP.
void add_frames_option(CLI::App& command, FrameSelection& frames);
/// --segmentation METHOD, or under other names.
void add_segmentation_option(CLI::App& command, std::optional<SegmentationMethod>& method,
                             const std::string& names = "--segmentation");
/// --grasp fixed|soft|free.
void add_grasp_option(CLI::App& command, std::string& grasp);
GraspConstraint grasp_constraint_from_name(const std::string& name);
/// --voxel-mm LENGTH.
void add_voxel_option(CLI::App& command, HullOptions& options);

/// Throws Error where an output exists and may not be replaced.
void check_free(const std::string& output, bool force);

/// Writes a file under another name beside it, which it takes over when whole.
void write_whole(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path&)>& write);

/// "right" or "left"; throws Error otherwise.
Side side_from_name(const std::string& name);

/// Which hand a take shows: what it says, or `asked` where it does not. Throws Error where neither
/// does and where they differ.
Side choose_side(const Take& take, const std::string& asked);

/// The built-in hand of the mean adult, or, unless `file` is empty, the hand in it: skinned (GLB,
/// glTF), scanned, or the built-in one in a shape (TOML). Without a side it is the file's own; the
/// built-in hand is a right one.
HandModel load_hand(const std::string& file, std::optional<Side> side);

/// The mean silhouette overlap of each camera over the frames that are ok.
std::map<std::string, double> mean_overlaps(const Result& result);

/// How many frames have each status.
std::map<std::string, int> count_statuses(const Result& result);

/// What is said of the views that were not used: a line for each camera and reason.
class LeftOut {
 public:
  /// In the frames' order.
  void add(const std::string& frame, const std::map<std::string, std::string>& why_by_camera);
  /// "camera_1 was left out of 2 frames (000005, 000006): its picture cannot be read".
  std::string lines() const;

 private:
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> frames_;
};

/// "left 0.97, right 0.95".
std::string overlap_text(const std::map<std::string, double>& overlaps);

}  // namespace tegata
