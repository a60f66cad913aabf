// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/truth.h"

#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/take/hand_json.h"
#include "tegata/take/json_value.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

constexpr std::string_view kFormat = "tegata-truth";
constexpr int kVersion = 1;
constexpr std::array<std::string_view, 4> kTruthKeys = {"format", "version", "side", "frames"};
constexpr std::array<std::string_view, 3> kFrameKeys = {"frame", "keypoints", "angles"};

}  // namespace

void write_truth_json(const Truth& truth, const std::filesystem::path& file) {
  nlohmann::ordered_json root;
  root["format"] = kFormat;
  root["version"] = kVersion;
  root["side"] = side_name(truth.side);
  root["frames"] = nlohmann::ordered_json::array();
  for (const TruthFrame& frame : truth.frames) {
    nlohmann::ordered_json entry;
    entry["frame"] = frame.name;
    entry["keypoints"] = keypoints_to_json(frame.keypoints);
    if (frame.angles) entry["angles"] = angles_to_json(*frame.angles);
    root["frames"].push_back(std::move(entry));
  }
  write_file(file, lines_of_json(root, file));
}

Truth read_truth_json(const std::filesystem::path& file) {
  const JsonValue root = JsonValue::read(file);
  root.expect_keys(kTruthKeys);
  // Made by other programs as well, which may leave these two out.
  if (root.has("format") || root.has("version")) expect_format(root, kFormat, kVersion);
  Truth truth;
  truth.side = side_from_json(root.at("side"));
  const JsonValue frames = root.at("frames");
  std::set<std::string> names;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const JsonValue entry = frames.item(i);
    entry.expect_keys(kFrameKeys);
    TruthFrame frame;
    frame.name = entry.at("frame").string();
    if (!names.insert(frame.name).second) {
      entry.at("frame").fail(text("'", frame.name, "' a second time"), "each frame once");
    }
    frame.keypoints = keypoints_from_json(entry.at("keypoints"));
    if (entry.has("angles")) frame.angles = angles_from_json(entry.at("angles"));
    truth.frames.push_back(std::move(frame));
  }
  return truth;
}

}  // namespace tegata
