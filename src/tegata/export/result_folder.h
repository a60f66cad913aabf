// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/hand/hand_model.h"
#include "tegata/take/result.h"

namespace tegata {

/// Writes result.json, angles.csv, hand.glb and meshes/<frame>.ply into an existing folder, as
/// docs/formats.md describes them.
void write_result_files(const Result& result, const HandModel& hand, double fps,
                        const std::filesystem::path& folder);

}  // namespace tegata
