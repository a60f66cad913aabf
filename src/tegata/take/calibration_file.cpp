// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_file.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

constexpr std::array<std::string_view, 6> kCameraKeys = {"name",        "size",     "matrix",
                                                         "distortions", "rotation", "translation"};
// What Anipose, FreeMoCap, Caliscope and Pose2Sim add; passed over, but for `fisheye` and `ignore`.
constexpr std::array<std::string_view, 12> kForeignCameraKeys = {"fisheye",
                                                                 "ignore",
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

int whole_pixels(const TomlTable& table, double value) {
  if (!(value >= 1.0 && value <= std::numeric_limits<int>::max()) || value != std::floor(value)) {
    table.fail("size", text(value), "whole numbers of pixels above 0");
  }
  return static_cast<int>(value);
}

void read_size(const TomlTable& table, Camera& camera) {
  const std::vector<double> size = table.numbers("size");
  if (size.size() != 2) {
    table.fail("size", text(size.size(), " numbers"), "2 numbers, width and height");
  }
  camera.width = whole_pixels(table, size[0]);
  camera.height = whole_pixels(table, size[1]);
}

void read_intrinsics(const TomlTable& table, Camera& camera) {
  constexpr double kTolerance = 1e-6;  // of the focal length, or of 1 in the last row
  const Eigen::Matrix3d k = table.matrix3("matrix");
  if ((k.row(2) - Eigen::RowVector3d(0.0, 0.0, 1.0)).cwiseAbs().maxCoeff() > kTolerance) {
    table.fail("matrix", text("the last row ", k(2, 0), " ", k(2, 1), " ", k(2, 2)), "0 0 1");
  }
  if (!(k(0, 0) > 0.0 && k(1, 1) > 0.0)) {
    table.fail("matrix", text("focal lengths ", k(0, 0), " and ", k(1, 1)),
               "positive numbers of pixels on the diagonal");
  }
  const double skew = std::max(std::abs(k(0, 1)), std::abs(k(1, 0)));
  if (skew > kTolerance * k(0, 0)) {
    table.fail("matrix", text("a skew of ", skew), "0 beside the focal lengths");
  }
  camera.fx = k(0, 0);
  camera.fy = k(1, 1);
  camera.cx = k(0, 2);
  camera.cy = k(1, 2);
}

void read_distortion(const TomlTable& table, Camera& camera) {
  std::vector<double> values = table.numbers("distortions");
  // OpenCV's 14 are the 12 and the tilt of the sensor, which is not modelled.
  if (values.size() == 14 && values[12] == 0.0 && values[13] == 0.0) values.resize(12);
  constexpr std::array<std::size_t, 5> kCounts = {0, 4, 5, 8, 12};
  if (std::find(kCounts.begin(), kCounts.end(), values.size()) == kCounts.end()) {
    table.fail("distortions", text(values.size(), " numbers"),
               "0, 4, 5, 8 or 12 numbers in the order of OpenCV");
  }
  std::copy(values.begin(), values.end(), camera.distortion.begin());
}

Eigen::Quaterniond read_rotation(const TomlTable& table) {
  if (!table.is_matrix("rotation")) return so3_exp(table.vector3("rotation"));
  constexpr double kTolerance = 1e-3;
  const Eigen::Matrix3d matrix = table.matrix3("rotation");
  const double off =
      (matrix * matrix.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (off > kTolerance) {
    table.fail("rotation", text("a matrix that is ", off, " off a rotation"),
               "rows that are orthogonal and of length 1");
  }
  if (matrix.determinant() < 0.0) {
    table.fail("rotation", "a rotation that mirrors", "a matrix of determinant +1");
  }
  // The nearest rotation to a matrix that was written with few digits.
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Eigen::Quaterniond(svd.matrixU() * svd.matrixV().transpose()).normalized();
}

bool is_camera(const TomlTable& table) {
  return std::any_of(kCameraMarks.begin(), kCameraMarks.end(),
                     [&](std::string_view key) { return table.has(key); });
}

void check_name(const TomlTable& table, const std::string& name) {
  // It is the name of a folder or of a video.
  if (name.empty() || name.find('/') != std::string::npos || name.front() == '.') {
    table.fail("name", text("'", name, "'"), "a name that a folder or a video can have");
  }
}

Camera read_camera(const TomlTable& table, const std::string& default_name,
                   double metres_per_unit) {
  table.expect_keys(kCameraKeys, kForeignCameraKeys);
  if (table.has("fisheye") && table.flag("fisheye")) {
    table.fail("fisheye", "true", "false: fisheye lenses are not supported yet");
  }
  Camera camera;
  camera.name = table.has("name") || default_name.empty() ? table.string("name") : default_name;
  check_name(table, camera.name);
  read_size(table, camera);
  read_intrinsics(table, camera);
  read_distortion(table, camera);
  camera.camera_from_world.rotation = read_rotation(table);
  camera.camera_from_world.translation = metres_per_unit * table.vector3("translation");
  return camera;
}

void add_camera(const TomlTable& table, const std::string& default_name, double metres_per_unit,
                CameraRig& rig) {
  if (table.has("ignore") && table.flag("ignore")) return;  // Caliscope's: not to be used
  rig.push_back(read_camera(table, default_name, metres_per_unit));
}

}  // namespace

CameraRig read_calibration(const std::filesystem::path& file, double metres_per_unit) {
  const TomlTable root = TomlTable::read(file);
  CameraRig rig;
  for (const std::string& key : root.keys()) {
    if (!root.is_table(key)) {
      if (std::find(kForeignRootKeys.begin(), kForeignRootKeys.end(), key) !=
          kForeignRootKeys.end()) {
        continue;
      }
      throw Error(root.where(), "key '", key,
                  "' is unknown, expected a table for each camera, as [cam_0], and [metadata]");
    }
    const TomlTable table = root.table(key);
    if (key == "cameras") {
      // Caliscope's layout: [cameras.0], whose videos are cam_0.mp4.
      for (const std::string& id : table.keys()) {
        add_camera(table.table(id), "cam_" + id, metres_per_unit, rig);
      }
    } else if (is_camera(table)) {
      add_camera(table, "", metres_per_unit, rig);
    }
  }
  try {
    check_rig(rig);
  } catch (const Error& error) {
    throw Error(file.string(), ": ", error.what());
  }
  return rig;
}

void write_calibration(const CameraRig& rig, const std::filesystem::path& file) {
  check_rig(rig);
  std::string content;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const Camera& camera = rig[i];
    std::size_t count = camera.distortion.size();
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
                    "\ntranslation = ", toml_numbers({translation.data(), 3}), "\n");
  }
  write_file(file, content);
}

}  // namespace tegata
