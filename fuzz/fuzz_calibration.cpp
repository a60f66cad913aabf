// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as calibration.toml. A rig that is read has cameras that can be used.
#include <cstring>

#include "memory_file.h"
#include "tegata/base/error.h"
#include "tegata/take/calibration_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  try {
    const tegata::CameraRig rig = tegata::read_calibration(file.path());
    tegata::require(rig.size() >= 2, "a rig of less than two cameras");
    for (const tegata::Camera& camera : rig) {
      tegata::require(camera.width > 0 && camera.height > 0, "a camera without pixels");
      tegata::require(camera.fx > 0.0 && camera.fy > 0.0, "a focal length that is not positive");
      tegata::require(camera.center_in_world().allFinite(), "a camera that is nowhere");
    }
  } catch (const tegata::Error& error) {
    tegata::require(std::strchr(error.what(), '\n') == nullptr, "an error of several lines");
  }
  return 0;
}
