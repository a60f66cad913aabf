// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tegata/hand/skeleton.h"

namespace tegata {

/// What is known of one frame of a take whose answer is known.
struct TruthFrame {
  std::string name;
  std::array<Eigen::Vector3d, kKeypointCount> keypoints;  ///< world [m]
  std::optional<JointAngles> angles;                      ///< [rad], where of the same convention
};

/// truth.json; the surfaces lie beside it in truth/<frame>.ply.
struct Truth {
  Side side = Side::right;
  std::vector<TruthFrame> frames;
};

void write_truth_json(const Truth& truth, const std::filesystem::path& file);
/// Throws Error naming file and key.
Truth read_truth_json(const std::filesystem::path& file);

}  // namespace tegata
