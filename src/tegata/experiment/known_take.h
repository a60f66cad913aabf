// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "tegata/hand/hand_model.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/pipeline/prepare_take.h"
#include "tegata/sim/virtual_room.h"
#include "tegata/take/truth.h"

namespace tegata {

/// A simulated take, prepared for fitting, and what is known of it.
struct KnownTake {
  PreparedTake prepared;
  std::vector<TruthFrame> truth;       ///< of the usable frames, in the scene
  std::vector<TriangleMesh> surfaces;  ///< the true ones, of these frames, in the scene
};

/// Makes a take in a new folder, prepares it by one thread and removes the folder.
KnownTake make_known_take(const HandModel& hand, const SimulationOptions& room,
                          const std::filesystem::path& folder);

/// Mean over the frames, as `tegata evaluate` measures it [mm]. A pose for each usable frame.
double surface_error_mm(const HandModel& hand, std::span<const HandPose> poses,
                        const KnownTake& known);

/// Mean over the frames and the first `angle_count` angles, of which four are the thumb's [deg].
double angle_error_deg(std::span<const HandPose> poses, const KnownTake& known, int angle_count);

}  // namespace tegata
