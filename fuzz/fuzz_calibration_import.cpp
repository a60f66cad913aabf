// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as the calibration of another tool. The first byte says which: COLMAP's two files with
// a zero byte between them, or one file that is told by its content, with or without a size for
// cameras that have none. A rig that is read has cameras that can be used.
#include <algorithm>
#include <cstring>
#include <string>

#include "memory_file.h"
#include "tegata/base/error.h"
#include "tegata/take/calibration_colmap.h"
#include "tegata/take/calibration_import.h"

namespace tegata {
namespace {

CameraRig read(std::uint8_t kind, const std::uint8_t* data, std::size_t size) {
  if (kind % 3 == 0) {
    const std::string content(reinterpret_cast<const char*>(data), size);
    const std::size_t zero = std::min(content.find('\0'), content.size());
    ColmapText files;
    files.cameras = content.substr(0, zero);
    files.images = content.substr(std::min(zero + 1, content.size()));
    CameraRig rig = read_colmap(files, 1.0);
    check_rig(rig);
    return rig;
  }
  CalibrationImportOptions options;
  if (kind % 3 == 1) options.size = PictureSize{640, 480};
  const MemoryFile file(data, size);
  return import_calibration(file.path(), options).rig;
}

}  // namespace
}  // namespace tegata

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    const tegata::CameraRig rig = tegata::read(data[0], data + 1, size - 1);
    tegata::require(rig.size() >= 2, "a rig of less than two cameras");
    for (const tegata::Camera& camera : rig) {
      tegata::require(camera.width > 0 && camera.height > 0, "a camera without pixels");
      tegata::require(camera.fx > 0.0 && camera.fy > 0.0, "a focal length that is not positive");
      tegata::require(camera.center_in_world().allFinite(), "a camera that is nowhere");
      const double turn = camera.camera_from_world.rotation.norm();
      tegata::require(turn > 0.999 && turn < 1.001, "a rotation that is none");
    }
  } catch (const tegata::Error& error) {
    tegata::require(std::strchr(error.what(), '\n') == nullptr, "an error of several lines");
  }
  return 0;
}
