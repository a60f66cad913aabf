// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What result.json and truth.json have in common; for this room's sources.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tegata/base/error.h"
#include "tegata/hand/skeleton.h"
#include "tegata/take/json_value.h"

namespace tegata {

inline nlohmann::ordered_json vector3_to_json(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

inline nlohmann::ordered_json angles_to_json(const JointAngles& angles) {
  auto list = nlohmann::ordered_json::array();
  for (const double angle : angles) list.push_back(angle);
  return list;
}

inline JointAngles angles_from_json(const JsonValue& value) {
  return Eigen::Map<const JointAngles>(value.numbers(kAngleCount).data());
}

inline nlohmann::ordered_json keypoints_to_json(
    const std::array<Eigen::Vector3d, kKeypointCount>& keypoints) {
  auto list = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& keypoint : keypoints) list.push_back(vector3_to_json(keypoint));
  return list;
}

inline std::array<Eigen::Vector3d, kKeypointCount> keypoints_from_json(const JsonValue& value) {
  std::array<Eigen::Vector3d, kKeypointCount> keypoints;
  if (value.size() != keypoints.size()) {
    value.fail(text("an array of ", value.size()), text(kKeypointCount, " points"));
  }
  for (std::size_t i = 0; i < keypoints.size(); ++i) keypoints[i] = value.item(i).vector3();
  return keypoints;
}

inline Side side_from_json(const JsonValue& value) {
  const std::string name = value.string();
  for (const Side side : {Side::right, Side::left}) {
    if (name == side_name(side)) return side;
  }
  value.fail(text("'", name, "'"), "'right' or 'left'");
}

/// Throws Error unless a file says that it is of this format and version.
inline void expect_format(const JsonValue& root, std::string_view format, int version) {
  const std::string got = root.at("format").string();
  if (got != format) root.at("format").fail(text("'", got, "'"), text("'", format, "'"));
  if (root.at("version").integer() != version) {
    root.at("version").fail(text(root.at("version").integer()), text(version));
  }
}

/// Whether a value and all in it can be written: JSON has no number for infinity.
inline bool has_finite_numbers(const nlohmann::ordered_json& value) {
  if (value.is_number_float()) return std::isfinite(value.get<double>());
  return !value.is_structured() || std::all_of(value.begin(), value.end(), has_finite_numbers);
}

/// The file's text: a line for each key, and in "frames" one for each frame, so that people can
/// read it and compare two. Throws Error, naming the file, for numbers that are not finite.
inline std::string lines_of_json(const nlohmann::ordered_json& root,
                                 const std::filesystem::path& file) {
  using nlohmann::ordered_json;
  if (!has_finite_numbers(root)) throw Error(file.string(), ": got a number that is not finite");
  // Names of files may be of any bytes.
  const auto line = [](const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  };
  std::string lines;
  for (const auto& [key, value] : root.items()) {
    lines += (lines.empty() ? "{" : ",\n ") + line(key) + ": ";
    if (key != "frames" || value.empty()) {
      lines += line(value);
      continue;
    }
    for (const ordered_json& frame : value) {
      lines += (&frame == &value.front() ? "[\n  " : ",\n  ") + line(frame);
    }
    lines += "]";
  }
  return lines + "}\n";
}

}  // namespace tegata
