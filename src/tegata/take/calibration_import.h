// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "tegata/camera/camera.h"

namespace tegata {

/// The layouts of calibrations that are read; docs/formats.md describes each.
enum class CalibrationFormat { toml, easymocap, colmap, kalibr, opencv };
std::string_view calibration_format_name(CalibrationFormat format);

/// Of a picture [px].
struct PictureSize {
  int width = 0, height = 0;
};

struct CalibrationImportOptions {
  double metres_per_unit = 1.0;
  std::optional<PictureSize> size;  ///< of cameras whose file does not say it
};

struct ImportedCalibration {
  CalibrationFormat format = CalibrationFormat::toml;
  CameraRig rig;  ///< in metres
};

/// Reads the cameras of a file, or of a folder that holds them, in whichever of the formats its
/// content is. Throws Error naming the file, the camera and the key for anything missing, of
/// another type or size, not finite, or that no camera has.
ImportedCalibration import_calibration(const std::filesystem::path& file_or_folder,
                                       const CalibrationImportOptions& options = {});

}  // namespace tegata
