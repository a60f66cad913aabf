// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_import.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/take/calibration_colmap.h"
#include "tegata/take/calibration_easymocap.h"
#include "tegata/take/calibration_fields.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/calibration_kalibr.h"
#include "tegata/take/calibration_opencv.h"
#include "tegata/take/data_tree.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLineBlanks = " \t\r";

// The two files of a calibration that comes in two: what is asked for may be either.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kPairs = {{
    {"intri.yml", "extri.yml"},
    {"intri.yaml", "extri.yaml"},
    {"intrinsics.yml", "extrinsics.yml"},
    {"intrinsics.xml", "extrinsics.xml"},
    {"intrinsics.json", "extrinsics.json"},
    {"cameras.txt", "images.txt"},
}};

// The first line that says something, without the blanks before it.
std::string_view first_line(std::string_view content) {
  while (!content.empty()) {
    const std::size_t end = std::min(content.find('\n'), content.size());
    const std::string_view line = content.substr(0, end);
    const std::size_t begin = line.find_first_not_of(kLineBlanks);
    if (begin != std::string_view::npos && line[begin] != '#') return line.substr(begin);
    content.remove_prefix(std::min(end + 1, content.size()));
  }
  return {};
}

// A table's head, or a key and an equals sign before any colon.
bool looks_like_toml(std::string_view content) {
  const std::string_view line = first_line(content);
  const std::size_t equals = line.find('='), colon = line.find(':');
  return line.starts_with('[') || (!line.starts_with('<') && !line.starts_with('%') &&
                                   equals != std::string_view::npos && equals < colon);
}

ImportedCalibration import_tree(const DataTree& first, const DataTree& second,
                                const CalibrationImportOptions& options) {
  if (is_opencv_stereo(first)) {
    return {CalibrationFormat::opencv, read_opencv_stereo(first, second, options)};
  }
  if (is_easymocap(first)) {
    return {CalibrationFormat::easymocap, read_easymocap(first, second, options)};
  }
  if (is_kalibr(first)) {
    return {CalibrationFormat::kalibr, read_kalibr(first, options.metres_per_unit)};
  }
  return {CalibrationFormat::opencv, read_opencv(first, options)};
}

ImportedCalibration import_file(const fs::path& file, const CalibrationImportOptions& options) {
  const std::string content = read_file(file);
  if (looks_like_toml(content)) {
    return {CalibrationFormat::toml, read_calibration(file, options.metres_per_unit)};
  }
  const DataTree tree = DataTree::parse(content, file.string());
  return import_tree(tree, tree, options);
}

ImportedCalibration import_pair(const fs::path& first, const fs::path& second,
                                const CalibrationImportOptions& options) {
  if (first.extension() == ".txt") {
    return {CalibrationFormat::colmap,
            read_colmap({read_file(first), read_file(second), first.string(), second.string()},
                        options.metres_per_unit)};
  }
  return import_tree(DataTree::read(first), DataTree::read(second), options);
}

ImportedCalibration import_folder(const fs::path& folder, const CalibrationImportOptions& options) {
  for (const auto& [first, second] : kPairs) {
    if (fs::exists(folder / first) && fs::exists(folder / second)) {
      return import_pair(folder / first, folder / second, options);
    }
  }
  if (fs::exists(folder / "calibration.toml")) {
    return import_file(folder / "calibration.toml", options);
  }
  throw Error(folder.string(), ": got a folder without a calibration, expected intri.yml and ",
              "extri.yml, cameras.txt and images.txt, intrinsics.yml and extrinsics.yml, or ",
              "calibration.toml; or give the file itself");
}

ImportedCalibration import_any(const fs::path& path, const CalibrationImportOptions& options) {
  if (fs::is_directory(path)) return import_folder(path, options);
  for (const auto& [first, second] : kPairs) {
    if (path.filename() != first && path.filename() != second) continue;
    const fs::path folder = path.parent_path();
    if (fs::exists(folder / first) && fs::exists(folder / second)) {
      return import_pair(folder / first, folder / second, options);
    }
  }
  return import_file(path, options);
}

}  // namespace

std::string_view calibration_format_name(CalibrationFormat format) {
  constexpr std::array<std::string_view, 5> kNames = {"Anipose-like TOML", "EasyMocap", "COLMAP",
                                                      "Kalibr", "OpenCV FileStorage"};
  return kNames.at(static_cast<std::size_t>(format));
}

ImportedCalibration import_calibration(const fs::path& file_or_folder,
                                       const CalibrationImportOptions& options) {
  ImportedCalibration imported = import_any(file_or_folder, options);
  check_rig_of_file(imported.rig, file_or_folder.string());
  return imported;
}

}  // namespace tegata
