// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_kalibr.h"

#include <algorithm>

#include "tegata/take/calibration_fields.h"
#include "tegata/take/picture_sequence.h"

namespace tegata {
namespace {

void read_lens(const DataTree& tree, Camera& camera) {
  const DataTree model = tree.child("camera_model");
  if (model.string() != "pinhole") model.fail(text("'", model.string(), "'"), "'pinhole'");
  const DataTree intrinsics = tree.child("intrinsics");
  const std::vector<double> values = intrinsics.numbers(4);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(0, 0) = values[0];
  matrix(1, 1) = values[1];
  matrix(0, 2) = values[2];
  matrix(1, 2) = values[3];
  set_matrix(camera, matrix, intrinsics.where());

  const DataTree distortion = tree.child("distortion_model");
  const std::string name = distortion.string();
  if (name == "none") return;
  if (name != "radtan" && name != "equidistant") {
    distortion.fail("'" + name + "'", "'radtan', 'equidistant' or 'none'");
  }
  const DataTree coefficients = tree.child("distortion_coeffs");
  set_distortion(camera, name == "radtan" ? LensModel::perspective : LensModel::fisheye,
                 coefficients.numbers(4), coefficients.where());
}

Rigid3d read_transform(const DataTree& tree, double metres_per_unit) {
  const Eigen::Matrix4d matrix =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(tree.numbers(16).data());
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-6) {
    tree.fail("another last row", "0 0 0 1");
  }
  return {rotation_from_matrix(matrix.topLeftCorner<3, 3>(), tree.where()),
          metres_per_unit * matrix.topRightCorner<3, 1>()};
}

}  // namespace

bool is_kalibr(const DataTree& root) {
  const std::vector<std::string> keys = root.keys();
  return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) {
    const DataTree child = root.child(key);
    return child.has("camera_model") && child.has("intrinsics");
  });
}

CameraRig read_kalibr(const DataTree& root, double metres_per_unit) {
  std::vector<std::string> names;
  for (const std::string& key : root.keys()) {
    if (root.child(key).has("camera_model")) names.push_back(key);
  }
  std::sort(names.begin(), names.end(),
            [](const std::string& a, const std::string& b) { return natural_less(a, b); });
  CameraRig rig;
  for (const std::string& name : names) {
    const DataTree tree = root.child(name);
    Camera camera;
    camera.name = name;
    check_camera_name(name, tree.where());
    read_lens(tree, camera);
    const DataTree size = tree.child("resolution");
    const std::vector<double> pixels = size.numbers(2);
    set_size(camera, pixels[0], pixels[1], size.where());
    if (!rig.empty()) {
      camera.camera_from_world =
          read_transform(tree.child("T_cn_cnm1"), metres_per_unit) * rig.back().camera_from_world;
    }
    rig.push_back(camera);
  }
  return rig;
}

}  // namespace tegata
