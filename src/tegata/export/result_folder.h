// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tegata/camera/camera.h"
#include "tegata/hand/hand_model.h"
#include "tegata/take/result.h"

namespace tegata {

/// Writes result.json, angles.csv, hand.glb and meshes/<frame>.ply into an existing folder, as
/// docs/formats.md describes them. The animation's keyframes are the frames, at their times since
/// the first one; without a pose the hand is hidden. The cameras go into it.
void write_result_files(const Result& result, const HandModel& hand,
                        const std::filesystem::path& folder, const CameraRig& cameras = {});

}  // namespace tegata
