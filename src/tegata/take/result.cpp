// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/result.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/take/hand_json.h"
#include "tegata/take/json_value.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view kFormat = "tegata-result";
constexpr int kVersion = 1;

// The one of the two quaternions of a rotation whose w is not negative, as w, x, y, z.
ordered_json rotation_to_json(const Eigen::Quaterniond& rotation) {
  const double sign = std::signbit(rotation.w()) ? -1.0 : 1.0;
  return {sign * rotation.w(), sign * rotation.x(), sign * rotation.y(), sign * rotation.z()};
}

Eigen::Quaterniond rotation_from_json(const JsonValue& value) {
  constexpr double kTolerance = 1e-3, kRounding = 1e-12;
  const std::vector<double> wxyz = value.numbers(4);
  const Eigen::Quaterniond rotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  const double off = std::abs(rotation.norm() - 1.0);
  if (!(off < kTolerance)) {
    value.fail(text("a quaternion of length ", rotation.norm()), "one of length 1: w, x, y, z");
  }
  // What this program wrote comes back to the bit.
  return off < kRounding ? rotation : rotation.normalized();
}

ordered_json frame_to_json(const ResultFrame& frame) {
  ordered_json entry;
  entry["frame"] = frame.name;
  entry["time"] = frame.time;
  entry["status"] = frame.status;
  if (frame.pose) {
    entry["rotation"] = rotation_to_json(frame.pose->world_from_hand.rotation);
    entry["translation"] = vector3_to_json(frame.pose->world_from_hand.translation);
    entry["angles"] = angles_to_json(frame.pose->angles);
    entry["keypoints"] = keypoints_to_json(frame.keypoints);
    entry["support"] = ordered_json::object();
    for (std::size_t bone = 0; bone < frame.support.size(); ++bone) {
      entry["support"][std::string(bone_names()[bone])] = frame.support[bone];
    }
  }
  entry["views"] = frame.views;
  if (frame.pose) {
    entry["silhouette_iou"] = frame.silhouette_iou;
    entry["uncovered"] = frame.uncovered;
  }
  if (!frame.left_out.empty()) entry["left_out"] = frame.left_out;
  return entry;
}

std::map<std::string, double> numbers_by_name(const JsonValue& object) {
  std::map<std::string, double> numbers;
  for (const std::string& key : object.keys()) numbers[key] = object.at(key).number();
  return numbers;
}

void read_support(const JsonValue& support, ResultFrame& frame) {
  const auto& names = bone_names();
  for (const std::string& key : support.keys()) {
    const auto found = std::find(names.begin(), names.end(), key);
    if (found == names.end()) support.fail(text("the bone '", key, "'"), "names of bones");
    frame.support[static_cast<std::size_t>(found - names.begin())] = support.at(key).number();
  }
}

ResultFrame frame_from_json(const JsonValue& entry) {
  ResultFrame frame;
  frame.name = entry.at("frame").string();
  frame.time = entry.at("time").number();
  frame.status = entry.at("status").string();
  if (entry.has("views")) {
    const JsonValue views = entry.at("views");
    for (std::size_t i = 0; i < views.size(); ++i) frame.views.push_back(views.item(i).string());
  }
  if (entry.has("left_out")) {
    const JsonValue reasons = entry.at("left_out");
    for (const std::string& camera : reasons.keys()) {
      frame.left_out[camera] = reasons.at(camera).string();
    }
  }
  if (!entry.has("rotation")) {
    if (frame.status == "ok") entry.at("rotation");  // is missing
    return frame;
  }
  HandPose& pose = frame.pose.emplace();
  pose.world_from_hand.rotation = rotation_from_json(entry.at("rotation"));
  pose.world_from_hand.translation = entry.at("translation").vector3();
  pose.angles = angles_from_json(entry.at("angles"));
  frame.keypoints = keypoints_from_json(entry.at("keypoints"));
  read_support(entry.at("support"), frame);
  frame.silhouette_iou = numbers_by_name(entry.at("silhouette_iou"));
  if (entry.has("uncovered")) frame.uncovered = numbers_by_name(entry.at("uncovered"));
  return frame;
}

ordered_json start_to_json(const ResultStart& start) {
  ordered_json entry = {{"frame", start.frame}};
  if (std::isfinite(start.lead)) entry["lead"] = start.lead;
  return entry;
}

ResultStart start_from_json(const JsonValue& entry) {
  ResultStart start;
  start.frame = entry.at("frame").string();
  if (entry.has("lead")) start.lead = entry.at("lead").number();
  return start;
}

void read_model(const JsonValue& model, Result& result) {
  result.model_name = model.at("name").string();
  result.model_shape = numbers_by_name(model.at("shape"));
  if (model.has("scale")) {
    result.model_scale = model.at("scale").number();
    if (!(result.model_scale > 0.0)) {
      model.at("scale").fail(text(result.model_scale), "a number above 0");
    }
  }
  if (model.has("scale_standard_deviation")) {
    result.model_scale_standard_deviation = model.at("scale_standard_deviation").number();
  }
}

// Another order of the names would mean other numbers.
void expect_names(const JsonValue& list, std::span<const std::string_view> names) {
  if (list.size() != names.size()) {
    list.fail(text("an array of ", list.size()), text(names.size(), " names"));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string got = list.item(i).string();
    if (got != names[i]) list.item(i).fail(text("'", got, "'"), text("'", names[i], "'"));
  }
}

void expect_unit(const JsonValue& units, std::string_view quantity, std::string_view unit) {
  const std::string got = units.at(quantity).string();
  if (got != unit) units.at(quantity).fail(text("'", got, "'"), text("'", unit, "'"));
}

// A cell of a table whose name may hold anything (RFC 4180).
std::string csv_cell(const std::string& content) {
  if (content.find_first_of(",\"\r\n") == std::string::npos) return content;
  std::string quoted = "\"";
  for (const char c : content) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// Without the sign of a zero that was rounded, and with a point whatever the user's language.
std::string fixed(double number, int decimals) {
  std::array<char, 512> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  std::string written(digits.data(), end);
  if (written.find_first_not_of("-0.") == std::string::npos && written.front() == '-') {
    written.erase(0, 1);
  }
  return written;
}

}  // namespace

void write_result_json(const Result& result, const std::filesystem::path& file) {
  ordered_json root;
  root["format"] = kFormat;
  root["version"] = kVersion;
  root["tegata"] = TEGATA_VERSION;
  root["take"] = result.take;
  root["hand"] = side_name(result.side);
  root["units"] = {{"length", "m"}, {"angle", "rad"}};
  root["joint_names"] = angle_names();
  root["keypoint_names"] = keypoint_names();
  root["model"] = {
      {"name", result.model_name}, {"shape", result.model_shape}, {"scale", result.model_scale}};
  if (result.model_scale_standard_deviation) {
    root["model"]["scale_standard_deviation"] = *result.model_scale_standard_deviation;
  }
  root["grasp"] = {{"angles", angles_to_json(result.grasp_angles)},
                   {"standard_deviations", angles_to_json(result.grasp_standard_deviations)}};
  root["frames"] = ordered_json::array();
  for (const ResultFrame& frame : result.frames) root["frames"].push_back(frame_to_json(frame));
  root["report"] = {{"iterations", result.iterations},
                    {"termination", result.termination},
                    {"seconds", result.seconds}};
  if (result.start) root["report"]["start"] = start_to_json(*result.start);
  write_file(file, lines_of_json(root, file));
}

Result read_result_json(const std::filesystem::path& file) {
  const JsonValue root = JsonValue::read(file);
  expect_format(root, kFormat, kVersion);
  expect_unit(root.at("units"), "length", "m");
  expect_unit(root.at("units"), "angle", "rad");
  expect_names(root.at("joint_names"), angle_names());
  expect_names(root.at("keypoint_names"), keypoint_names());
  Result result;
  result.take = root.at("take").string();
  result.side = side_from_json(root.at("hand"));
  read_model(root.at("model"), result);
  result.grasp_angles = angles_from_json(root.at("grasp").at("angles"));
  result.grasp_standard_deviations = angles_from_json(root.at("grasp").at("standard_deviations"));
  const JsonValue frames = root.at("frames");
  std::set<std::string> names;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    result.frames.push_back(frame_from_json(frames.item(i)));
    const std::string& name = result.frames.back().name;
    if (!names.insert(name).second) {
      frames.item(i).at("frame").fail(text("'", name, "' a second time"), "each frame once");
    }
  }
  const JsonValue report = root.at("report");
  result.iterations = report.at("iterations").integer();
  result.termination = report.at("termination").string();
  result.seconds = numbers_by_name(report.at("seconds"));
  if (report.has("start")) result.start = start_from_json(report.at("start"));
  return result;
}

void write_angles_csv(const Result& result, const std::filesystem::path& file) {
  std::string table = "frame,time_s";
  for (const std::string_view name : angle_names()) table += text(",", name, "_deg");
  table += "\n";
  for (const ResultFrame& frame : result.frames) {
    table += csv_cell(frame.name) + "," + fixed(frame.time, 6);
    for (int angle = 0; angle < kAngleCount; ++angle) {
      table += ",";
      if (frame.pose) table += fixed(kDegreesPerRadian * frame.pose->angles[angle], 4);
    }
    table += "\n";
  }
  write_file(file, table);
}

}  // namespace tegata
