// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"
#include "tegata/take/calibration_fields.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

constexpr std::array<std::string_view, 7> kCameraKeys = {
    "name", "size", "matrix", "distortions", "rotation", "translation", "fisheye"};
// What Anipose, FreeMoCap, Caliscope and Pose2Sim add; passed over, but for `ignore`.
constexpr std::array<std::string_view, 11> kForeignCameraKeys = {"ignore",
                                                                 "cam_id",
                                                                 "port",
                                                                 "error",
                                                                 "exposure",
                                                                 "rotation_count",
                                                                 "grid_count",
                                                                 "adjusted",
                                                                 "world_position",
                                                                 "world_orientation",
                                                                 "verified_resolutions"};
// What tells a camera's table from another tool's settings.
constexpr std::array<std::string_view, 4> kCameraMarks = {"matrix", "distortions", "rotation",
                                                          "translation"};
// Values outside of any table that Caliscope writes.
constexpr std::array<std::string_view, 2> kForeignRootKeys = {"CreationDate", "camera_count"};

std::string where(const TomlTable& table, std::string_view key) {
  return text(table.where(), "key '", key, "'");
}

void read_size(const TomlTable& table, Camera& camera) {
  const std::vector<double> size = table.numbers("size");
  if (size.size() != 2) {
    table.fail("size", text(size.size(), " numbers"), "2 numbers, width and height");
  }
  set_size(camera, size[0], size[1], where(table, "size"));
}

Eigen::Quaterniond read_rotation(const TomlTable& table) {
  if (!table.is_matrix("rotation")) return so3_exp(table.vector3("rotation"));
  return rotation_from_matrix(table.matrix3("rotation"), where(table, "rotation"));
}

bool is_camera(const TomlTable& table) {
  return std::any_of(kCameraMarks.begin(), kCameraMarks.end(),
                     [&](std::string_view key) { return table.has(key); });
}

bool among(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Whether a file has what only other tools write; their next versions may write still more.
bool is_foreign(const TomlTable& root) {
  if (root.has("metadata") || root.has("cameras")) return true;
  for (const std::string& key : root.keys()) {
    if (!root.is_table(key)) {
      if (among(kForeignRootKeys, key)) return true;
      continue;
    }
    const std::vector<std::string> keys = root.table(key).keys();
    if (std::any_of(keys.begin(), keys.end(),
                    [](const std::string& k) { return among(kForeignCameraKeys, k); })) {
      return true;
    }
  }
  return false;
}

struct Reading {
  double metres_per_unit = 1.0;
  bool foreign = false;
  CameraRig rig;
};

void add_camera(const TomlTable& table, const std::string& default_name, Reading& reading) {
  if (table.has("ignore") && table.flag("ignore")) return;  // Caliscope's: not to be used
  if (!reading.foreign) table.expect_keys(kCameraKeys);
  Camera camera;
  camera.name = table.has("name") || default_name.empty() ? table.string("name") : default_name;
  check_camera_name(camera.name, where(table, "name"));
  read_size(table, camera);
  set_matrix(camera, table.matrix3("matrix"), where(table, "matrix"));
  const bool fisheye = table.has("fisheye") && table.flag("fisheye");
  set_distortion(camera, fisheye ? LensModel::fisheye : LensModel::perspective,
                 table.numbers("distortions"), where(table, "distortions"));
  camera.camera_from_world.rotation = read_rotation(table);
  camera.camera_from_world.translation = reading.metres_per_unit * table.vector3("translation");
  reading.rig.push_back(camera);
}

}  // namespace

CameraRig read_calibration(const std::filesystem::path& file, double metres_per_unit) {
  const TomlTable root = TomlTable::read(file);
  Reading reading{metres_per_unit, is_foreign(root), {}};
  for (const std::string& key : root.keys()) {
    if (!root.is_table(key)) {
      if (reading.foreign) continue;
      throw Error(root.where(), "key '", key,
                  "' is unknown, expected a table for each camera, as [cam_0], and [metadata]");
    }
    const TomlTable table = root.table(key);
    if (key == "cameras") {
      // Caliscope's layout: [cameras.0], whose videos are cam_0.mp4.
      for (const std::string& id : table.keys()) {
        add_camera(table.table(id), "cam_" + id, reading);
      }
    } else if (is_camera(table)) {
      add_camera(table, "", reading);
    }
  }
  check_rig_of_file(reading.rig, file.string());
  return reading.rig;
}

void write_calibration(const CameraRig& rig, const std::filesystem::path& file) {
  check_rig(rig);
  std::string content;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const Camera& camera = rig[i];
    const bool fisheye = camera.lens_model == LensModel::fisheye;
    std::size_t count = fisheye ? 4 : camera.distortion.size();
    while (count > 5 && camera.distortion[count - 1] == 0.0) --count;
    if (count > 5) count = count > 8 ? 12 : 8;
    const Eigen::Vector3d rotation = so3_log(camera.camera_from_world.rotation.normalized());
    const Eigen::Vector3d& translation = camera.camera_from_world.translation;
    const std::array<double, 3> first = {camera.fx, 0.0, camera.cx};
    const std::array<double, 3> second = {0.0, camera.fy, camera.cy};
    content += text(i == 0 ? "" : "\n", "[cam_", i, "]\nname = ", toml_string(camera.name),
                    "\nsize = [", camera.width, ", ", camera.height, "]\nmatrix = [",
                    toml_numbers(first), ", ", toml_numbers(second), ", [0.0, 0.0, 1.0]]",
                    "\ndistortions = ", toml_numbers({camera.distortion.data(), count}),
                    "\nrotation = ", toml_numbers({rotation.data(), 3}),
                    "\ntranslation = ", toml_numbers({translation.data(), 3}),
                    fisheye ? "\nfisheye = true\n" : "\n");
  }
  write_file(file, content);
}

}  // namespace tegata
