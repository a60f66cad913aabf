// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tegata/export/exported_frames.h"
#include "tegata/hand/hand_model.h"
#include "tegata/take/result.h"

namespace tegata {

/// A folder for robot programs, as docs/formats.md describes it: hand.urdf, the hand's rigid links
/// and their joints with limits and inertials, `density` in kg/m^3; meshes/<bone>.stl; and
/// joint_states.csv, the movement by the joints' names. Cells of frames without a pose are empty.
std::vector<ExportedFile> urdf_files(const Result& result, const HandModel& hand, double density);

}  // namespace tegata
