// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <sstream>

#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/take/hand_shape_file.h"
#include "tegata/take/scanned_hand.h"

namespace tegata {
namespace {

/// FIRST:LAST or FIRST:LAST:STEP; LAST may be empty.
FrameSelection parse_frames(const std::string& value) {
  const auto fail = [&value] {
    return CLI::ValidationError(
        "--frames", "got '" + value + "', expected FIRST:LAST, FIRST:LAST:STEP or FIRST::STEP");
  };
  std::vector<std::optional<std::size_t>> parts;
  std::istringstream stream(value + ":");  // so that an empty last part counts
  for (std::string part; std::getline(stream, part, ':');) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (!part.empty() && (error != std::errc() || end != part.data() + part.size())) throw fail();
    parts.push_back(part.empty() ? std::nullopt : std::optional(number));
  }
  if (parts.size() < 2 || parts.size() > 3) throw fail();
  FrameSelection frames{parts[0].value_or(0), parts[1], 1};
  if (parts.size() == 3) frames.step = parts[2].value_or(1);
  if (frames.step == 0 || (frames.last && *frames.last < frames.first)) throw fail();
  return frames;
}

void check_side(const std::string& file, Side got, std::optional<Side> expected) {
  if (!expected || got == *expected) return;
  throw Error(file, ": it holds a ", side_name(got), " hand, expected a ", side_name(*expected),
              " one; `tegata hand convert --mirror` makes one of it");
}

HandModel load_toml_hand(const std::string& file, std::optional<Side> side) {
  if (is_hand_shape_file(file)) {
    const HandShapeFile shape = read_hand_shape(file);
    check_side(file, shape.side, side);
    HandModel model = built_in_hand(shape_from_parameters(shape.parameters), shape.side);
    model.name = shape.name;
    return model;
  }
  const ScannedHand scan = read_scanned_hand(file);
  check_side(file, scan.side, side);
  return rigged(scan);
}

}  // namespace

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "Threads to use; 0: one per core")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--json", options.json, "Print one JSON object for scripts");
  command.add_flag("--quiet,-q", options.quiet, "No progress and no warnings, errors only");
}

void add_frames_option(CLI::App& command, FrameSelection& frames) {
  command.add_option_function<std::string>(
      "--frames", [&frames](const std::string& value) { frames = parse_frames(value); },
      "FIRST:LAST:STEP, by position from 0; LAST is included and may be left out");
}

void add_segmentation_option(CLI::App& command, std::optional<SegmentationMethod>& method,
                             const std::string& names) {
  command
      .add_option_function<std::string>(
          names,
          [&method](const std::string& name) { method = segmentation_method_from_name(name); },
          "How pictures become silhouettes; else what the take says or shows")
      ->check(CLI::IsMember({"infrared", "background", "skin", "mask"}));
}

void add_grasp_option(CLI::App& command, std::string& grasp) {
  command
      .add_option(
          "--grasp", grasp,
          "fixed: one set of joint angles for all frames; soft: each frame's depart from it "
          "a little; free: one a frame")
      ->check(CLI::IsMember({"fixed", "soft", "free"}))
      ->capture_default_str();
}

GraspConstraint grasp_constraint_from_name(const std::string& name) {
  if (name == "free") return GraspConstraint::free;
  return name == "soft" ? GraspConstraint::soft : GraspConstraint::fixed;
}

void add_voxel_option(CLI::App& command, HullOptions& options) {
  command
      .add_option_function<double>(
          "--voxel-mm", [&options](double voxel_mm) { options.voxel_size = 1e-3 * voxel_mm; },
          "Finest cell of the visual hull")
      ->check(CLI::Range(0.1, 50.0))
      ->default_str(fmt::format("{}", 1e3 * options.voxel_size));
}

void check_free(const std::string& output, bool force) {
  if (!force && std::filesystem::exists(output)) {
    throw Error(output, ": it exists already; --force replaces it");
  }
}

void write_whole(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path&)>& write) {
  const std::filesystem::path partial =
      file.parent_path() / (".partial-" + file.filename().string());
  std::error_code ignored;
  try {
    write(partial);
    std::filesystem::rename(partial, file);
  } catch (const std::exception& problem) {
    std::filesystem::remove(partial, ignored);
    std::string message = problem.what();
    if (const std::size_t at = message.find(partial.string()); at != std::string::npos) {
      message.replace(at, partial.string().size(), file.string());
    }
    throw Error(message);
  }
}

Side side_from_name(const std::string& name) {
  for (const Side side : {Side::right, Side::left}) {
    if (name == side_name(side)) return side;
  }
  throw Error("hand: got '", name, "', expected right or left");
}

Side choose_side(const Take& take, const std::string& asked) {
  const std::optional<Side>& known = take.info().side;
  if (!known && asked.empty()) {
    throw Error(take.folder().string(),
                ": the take does not say which hand it shows; give --side right or left, or set "
                "hand in take.toml");
  }
  if (asked.empty()) return *known;
  const Side side = side_from_name(asked);
  if (known && *known != side) {
    throw Error(take.folder().string(), ": got --side ", asked, ", but take.toml says ",
                side_name(*known));
  }
  return side;
}

HandModel load_hand(const std::string& file, std::optional<Side> side) {
  if (file.empty()) return built_in_hand(HandShape{}, side.value_or(Side::right));
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending == ".toml") return load_toml_hand(file, side);
  if (ending != ".glb" && ending != ".gltf") {
    throw Error(
        file, ": got '", ending,
        "', expected a hand that ends in .glb, .gltf or .toml; a mesh needs a TOML with its "
        "joints (docs/formats.md)");
  }
  if (side) return read_hand_gltf(file, *side);
  try {
    return read_hand_gltf(file, Side::right);
  } catch (const Error&) {
    const std::exception_ptr as_right = std::current_exception();
    try {
      return read_hand_gltf(file, Side::left);
    } catch (const Error&) {
      std::rethrow_exception(as_right);
    }
  }
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

void LeftOut::add(const std::string& frame,
                  const std::map<std::string, std::string>& why_by_camera) {
  for (const auto& why : why_by_camera) frames_[why].push_back(frame);
}

std::string LeftOut::lines() const {
  constexpr std::size_t kMostNames = 5;
  std::string lines;
  for (const auto& [camera_and_why, names] : frames_) {
    std::string list;
    for (std::size_t i = 0; i < std::min(kMostNames, names.size()); ++i) {
      list += (i == 0 ? "" : ", ") + names[i];
    }
    if (names.size() > kMostNames) list += " .. " + names.back();
    lines += fmt::format("{} was left out of {} frame{} ({}): {}\n", camera_and_why.first,
                         names.size(), names.size() == 1 ? "" : "s", list, camera_and_why.second);
  }
  return lines;
}

std::string overlap_text(const std::map<std::string, double>& overlaps) {
  std::string line;
  for (const auto& [camera, overlap] : overlaps) {
    line += fmt::format("{}{} {:.2f}", line.empty() ? "" : ", ", camera, overlap);
  }
  return line;
}

}  // namespace tegata
