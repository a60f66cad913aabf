// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What the targets of readers have in common.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "bytes.h"
#include "tegata/base/error.h"
#include "tegata/camera/camera.h"
#include "tegata/take/calibration_import.h"

namespace tegata {

/// What is read is sound, or the Error that says why it is not read is one line.
template <typename Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    require(std::strchr(error.what(), '\n') == nullptr, "an error of several lines");
  }
}

/// Two files with a zero byte between them; where there is none, one file and an empty one.
inline std::pair<std::string, std::string> two_files(const std::uint8_t* data, std::size_t size) {
  const std::string content(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = std::min(content.find('\0'), content.size());
  return {content.substr(0, zero), content.substr(std::min(zero + 1, content.size()))};
}

/// Cameras that can be used.
inline void require_usable(const CameraRig& rig) {
  require(rig.size() >= 2, "a rig of less than two cameras");
  for (const Camera& camera : rig) {
    require(camera.width > 0 && camera.height > 0, "a camera without pixels");
    require(camera.fx > 0.0 && camera.fy > 0.0, "a focal length that is not positive");
    require(camera.center_in_world().allFinite(), "a camera that is nowhere");
    const double turn = camera.camera_from_world.rotation.norm();
    require(turn > 0.999 && turn < 1.001, "a rotation that is none");
  }
}

/// Reads cameras with and without a size for those that have none.
template <typename Read>
void read_rigs_or_refuse(const Read& read) {
  const std::array<std::optional<PictureSize>, 2> sizes = {std::nullopt, PictureSize{640, 480}};
  for (const std::optional<PictureSize>& size : sizes) {
    read_or_refuse([&] {
      CalibrationImportOptions options;
      options.size = size;
      const CameraRig rig = read(options);
      check_rig(rig);
      require_usable(rig);
    });
  }
}

}  // namespace tegata
