// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/take_info.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "tegata/base/error.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

constexpr std::array<std::string_view, 4> kMethodNames = {"infrared", "background", "skin", "mask"};
constexpr std::array<std::string_view, 7> kKeys = {
    "name", "hand", "fps", "metres_per_unit", "initial_pose", "segmentation", "offset"};
constexpr std::array<std::string_view, 3> kLandmarkKeys = {"wrist", "index_mcp", "little_mcp"};
constexpr std::array<std::string_view, 2> kSegmentationKeys = {"method", "hand_label"};
constexpr int kMostLabel = 65535, kMostOffset = 1000000;

Side read_side(const TomlTable& root) {
  const std::string name = root.string("hand");
  for (const Side side : {Side::right, Side::left}) {
    if (name == side_name(side)) return side;
  }
  root.fail("hand", text("'", name, "'"), "'right' or 'left'");
}

InitialLandmarks read_landmarks(const TomlTable& table) {
  table.expect_keys(kLandmarkKeys);
  return {table.vector3("wrist"), table.vector3("index_mcp"), table.vector3("little_mcp")};
}

SegmentationMethod read_method(const TomlTable& table) {
  const std::string name = table.string("method");
  if (std::find(kMethodNames.begin(), kMethodNames.end(), name) == kMethodNames.end()) {
    table.fail("method", text("'", name, "'"), one_of(kMethodNames));
  }
  return segmentation_method_from_name(name);
}

std::string landmark_line(std::string_view name, const Eigen::Vector3d& point) {
  return text(name, " = ", toml_numbers({point.data(), 3}), "\n");
}

}  // namespace

std::string_view segmentation_method_name(SegmentationMethod method) {
  return kMethodNames[static_cast<std::size_t>(method)];
}

SegmentationMethod segmentation_method_from_name(std::string_view name) {
  const auto found = std::find(kMethodNames.begin(), kMethodNames.end(), name);
  if (found == kMethodNames.end()) {
    throw Error("segmentation: got '", name, "', expected ", one_of(kMethodNames));
  }
  return static_cast<SegmentationMethod>(found - kMethodNames.begin());
}

TakeInfo read_take_info(const std::filesystem::path& file) {
  const TomlTable root = TomlTable::read(file);
  root.expect_keys(kKeys);
  TakeInfo info;
  if (root.has("name")) info.name = root.string("name");
  if (root.has("hand")) info.side = read_side(root);
  if (root.has("fps")) info.fps = root.positive_number("fps");
  if (root.has("metres_per_unit")) info.metres_per_unit = root.positive_number("metres_per_unit");
  if (root.has("initial_pose")) info.initial_landmarks = read_landmarks(root.table("initial_pose"));
  if (root.has("segmentation")) {
    const TomlTable table = root.table("segmentation");
    table.expect_keys(kSegmentationKeys);
    if (table.has("method")) info.segmentation = read_method(table);
    if (table.has("hand_label")) info.hand_label = table.whole_number("hand_label", 1, kMostLabel);
  }
  if (root.has("offset")) {
    const TomlTable table = root.table("offset");
    for (const std::string& camera : table.keys()) {
      info.offsets[camera] = table.whole_number(camera, -kMostOffset, kMostOffset);
    }
  }
  return info;
}

void write_take_info(const TakeInfo& info, const std::filesystem::path& file) {
  std::string content;
  if (!info.name.empty()) content += text("name = ", toml_string(info.name), "\n");
  if (info.side) content += text("hand = \"", side_name(*info.side), "\"\n");
  content += text("fps = ", toml_number(info.fps),
                  "\nmetres_per_unit = ", toml_number(info.metres_per_unit), "\n");
  if (info.initial_landmarks) {
    content += text("\n[initial_pose]\n", landmark_line("wrist", info.initial_landmarks->wrist),
                    landmark_line("index_mcp", info.initial_landmarks->index_mcp),
                    landmark_line("little_mcp", info.initial_landmarks->little_mcp));
  }
  if (info.segmentation || info.hand_label) content += "\n[segmentation]\n";
  if (info.segmentation) {
    content += text("method = \"", segmentation_method_name(*info.segmentation), "\"\n");
  }
  if (info.hand_label) content += text("hand_label = ", *info.hand_label, "\n");
  if (!info.offsets.empty()) content += "\n[offset]\n";
  for (const auto& [camera, offset] : info.offsets) {
    content += text(toml_string(camera), " = ", offset, "\n");
  }
  write_file(file, content);
}

}  // namespace tegata
