// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_opencv.h"

#include <algorithm>
#include <optional>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"
#include "tegata/take/calibration_fields.h"

namespace tegata {
namespace {

using Keys = std::vector<std::string_view>;
const Keys& matrix_keys() {
  static const Keys keys = {"camera_matrix", "Camera_Matrix", "K", "M", "matrix"};
  return keys;
}
const Keys& distortion_keys() {
  static const Keys keys = {"distortion_coefficients",
                            "Distortion_Coefficients",
                            "dist_coeffs",
                            "distortion",
                            "distortions",
                            "dist",
                            "D"};
  return keys;
}

bool has_any(const DataTree& tree, const Keys& keys) {
  return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return tree.has(key); });
}

void read_image_size(const DataTree& tree, const CalibrationImportOptions& options,
                     Camera& camera) {
  const Keys width = {"image_width", "image_Width", "width"};
  const Keys height = {"image_height", "image_Height", "height"};
  const Keys both = {"image_size", "imageSize", "size", "resolution"};
  if (has_any(tree, width) && has_any(tree, height)) {
    const DataTree node = tree.child_of(width);
    set_size(camera, node.number(), tree.child_of(height).number(), node.where());
  } else if (has_any(tree, both)) {
    const DataTree node = tree.child_of(both);
    const std::vector<double> size = node.numbers(2);
    set_size(camera, size[0], size[1], node.where());
  } else if (options.size) {
    set_size(camera, options.size->width, options.size->height, "size");
  } else {
    throw Error(tree.where(), ": got no image_width and image_height, expected the pictures' size ",
                "there or with --size");
  }
}

LensModel read_model(const DataTree& tree) {
  if (tree.has("fisheye")) {
    const std::string flag = tree.child("fisheye").string();
    return flag == "1" || flag == "true" ? LensModel::fisheye : LensModel::perspective;
  }
  for (const std::string_view key : {"distortion_model", "model"}) {
    if (!tree.has(key)) continue;
    const std::string name = tree.child(key).string();
    if (name == "fisheye" || name == "equidistant") return LensModel::fisheye;
    if (name != "plumb_bob" && name != "rational_polynomial" && name != "pinhole" &&
        name != "perspective" && name != "radtan") {
      tree.child(key).fail("'" + name + "'",
                           "'fisheye', 'equidistant', 'plumb_bob' or 'rational_polynomial'");
    }
  }
  return LensModel::perspective;
}

Eigen::Quaterniond read_rotation(const DataTree& tree) {
  if (tree.numbers().size() == 9) return rotation_from_matrix(tree.matrix3(), tree.where());
  return so3_exp(tree.vector3());
}

Camera read_camera(const DataTree& tree, const std::string& default_name,
                   const CalibrationImportOptions& options) {
  Camera camera;
  camera.name = tree.has("name") ? tree.child("name").string() : default_name;
  check_camera_name(camera.name, tree.where());
  const DataTree matrix = tree.child_of(matrix_keys());
  set_matrix(camera, matrix.matrix3(), matrix.where());
  const DataTree distortion = tree.child_of(distortion_keys());
  set_distortion(camera, read_model(tree), distortion.numbers(), distortion.where());
  read_image_size(tree, options, camera);
  camera.camera_from_world = {
      read_rotation(tree.child_of({"R", "rotation", "rotation_matrix", "rvec"})),
      options.metres_per_unit *
          tree.child_of({"T", "t", "translation", "translation_vector", "tvec"}).vector3()};
  return camera;
}

}  // namespace

bool is_opencv_stereo(const DataTree& intrinsics) {
  return intrinsics.has("M1") && intrinsics.has("M2");
}

CameraRig read_opencv_stereo(const DataTree& intrinsics, const DataTree& extrinsics,
                             const CalibrationImportOptions& options) {
  CameraRig rig;
  for (const std::string side : {"1", "2"}) {
    Camera camera;
    camera.name = side == "1" ? "left" : "right";
    const DataTree matrix = intrinsics.child("M" + side), distortion = intrinsics.child("D" + side);
    set_matrix(camera, matrix.matrix3(), matrix.where());
    set_distortion(camera, read_model(intrinsics), distortion.numbers(), distortion.where());
    read_image_size(intrinsics, options, camera);
    rig.push_back(camera);
  }
  rig[1].camera_from_world = {read_rotation(extrinsics.child("R")),
                              options.metres_per_unit * extrinsics.child("T").vector3()};
  return rig;
}

CameraRig read_opencv(const DataTree& root, const CalibrationImportOptions& options) {
  CameraRig rig;
  if (root.has("cameras") && root.child("cameras").is_sequence()) {
    for (const DataTree& tree : root.child("cameras").items()) {
      rig.push_back(read_camera(tree, text("cam_", rig.size()), options));
    }
    return rig;
  }
  const DataTree cameras = root.has("cameras") ? root.child("cameras") : root;
  if (has_any(cameras, matrix_keys())) {
    throw Error(root.where(), ": got the calibration of one camera, expected a map for each of ",
                "several, as cam_0: { camera_matrix, distortion_coefficients, R, T }");
  }
  for (const std::string& key : cameras.keys()) {
    const DataTree tree = cameras.child(key);
    if (has_any(tree, matrix_keys())) rig.push_back(read_camera(tree, key, options));
  }
  return rig;
}

}  // namespace tegata
