// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tegata/camera/camera.h"

namespace tegata {

/// Reads calibration.toml as docs/formats.md describes it; translations are multiplied by
/// `metres_per_unit`. Rotations are Rodrigues vectors or 3 x 3 matrices. Throws Error naming the
/// file, the table and the key for anything missing, of another type or size, not finite, singular,
/// or a rotation that mirrors. In files that show marks of other tools, unknown keys are passed
/// over.
CameraRig read_calibration(const std::filesystem::path& file, double metres_per_unit = 1.0);

/// Writes the same layout, in metres.
void write_calibration(const CameraRig& rig, const std::filesystem::path& file);

}  // namespace tegata
