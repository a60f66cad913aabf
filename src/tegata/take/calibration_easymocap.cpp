// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_easymocap.h"

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"
#include "tegata/take/calibration_fields.h"

namespace tegata {
namespace {

constexpr std::string_view kMatrix = "K_";

void read_size(const DataTree& intrinsics, const CalibrationImportOptions& options,
               Camera& camera) {
  const std::string width = "W_" + camera.name, height = "H_" + camera.name;
  if (intrinsics.has(width) && intrinsics.has(height)) {
    set_size(camera, intrinsics.child(width).number(), intrinsics.child(height).number(),
             intrinsics.child(width).where());
  } else if (options.size) {
    set_size(camera, options.size->width, options.size->height, "size");
  } else {
    throw Error(intrinsics.where(), ": camera '", camera.name, "': got neither '", width, "' nor '",
                height, "', expected the pictures' size there or with --size");
  }
}

Eigen::Quaterniond read_rotation(const DataTree& extrinsics, const std::string& name) {
  constexpr double kTolerance = 1e-3;  // [rad]
  const std::string vector = "R_" + name, matrix = "Rot_" + name;
  if (!extrinsics.has(matrix)) {
    // Some write the matrix where the vector belongs.
    const DataTree child = extrinsics.child(vector);
    if (child.numbers().size() == 9) return rotation_from_matrix(child.matrix3(), child.where());
    return so3_exp(child.vector3());
  }
  const DataTree child = extrinsics.child(matrix);
  const Eigen::Quaterniond rotation = rotation_from_matrix(child.matrix3(), child.where());
  if (extrinsics.has(vector) && extrinsics.child(vector).numbers().size() == 3) {
    const double off = rotation.angularDistance(so3_exp(extrinsics.child(vector).vector3()));
    if (off > kTolerance) {
      child.fail(text("a rotation that is ", off, " rad from '", vector, "'"), "the same rotation");
    }
  }
  return rotation;
}

}  // namespace

bool is_easymocap(const DataTree& root) {
  const std::vector<std::string> keys = root.keys();
  return std::any_of(keys.begin(), keys.end(), [](const std::string& key) {
    return key.starts_with(kMatrix) || key.starts_with("Rot_") || key.starts_with("R_");
  });
}

CameraRig read_easymocap(const DataTree& intrinsics, const DataTree& extrinsics,
                         const CalibrationImportOptions& options) {
  std::vector<std::string> names;
  if (intrinsics.has("names")) {
    for (const DataTree& name : intrinsics.child("names").items()) names.push_back(name.string());
  } else {
    for (const std::string& key : intrinsics.keys()) {
      if (key.starts_with(kMatrix)) names.push_back(key.substr(kMatrix.size()));
    }
  }
  CameraRig rig;
  for (const std::string& name : names) {
    Camera camera;
    camera.name = name;
    check_camera_name(name, intrinsics.where());
    const DataTree matrix = intrinsics.child(text(kMatrix, name));
    set_matrix(camera, matrix.matrix3(), matrix.where());
    const DataTree distortion = intrinsics.child_of({"dist_" + name, "D_" + name});
    set_distortion(camera, LensModel::perspective, distortion.numbers(), distortion.where());
    read_size(intrinsics, options, camera);
    camera.camera_from_world = {read_rotation(extrinsics, name),
                                options.metres_per_unit * extrinsics.child("T_" + name).vector3()};
    rig.push_back(camera);
  }
  return rig;
}

}  // namespace tegata
