// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tegata/hand/skeleton.h"

namespace tegata {

/// Three landmarks of the first frame in world coordinates [m], rough (1-2 cm) is enough.
struct InitialLandmarks {
  Eigen::Vector3d wrist, index_mcp, little_mcp;
};

enum class SegmentationMethod { infrared, background, skin, mask };
std::string_view segmentation_method_name(SegmentationMethod method);
/// Throws Error listing the names that would do.
SegmentationMethod segmentation_method_from_name(std::string_view name);

/// What take.toml says; everything is optional there.
struct TakeInfo {
  std::string name;  ///< the folder's name where the file does not say
  std::optional<Side> side;
  double fps = 30.0;
  double metres_per_unit = 1.0;  ///< already applied to the rig and not to the landmarks
  std::optional<InitialLandmarks> initial_landmarks;
  std::optional<SegmentationMethod> segmentation;
  /// Masks are label images, in which the hand has this number and the background 0.
  std::optional<int> hand_label;
  /// By camera: how many of its frames lie before the take's first one. Absent: 0.
  std::map<std::string, int> offsets;
};

/// Reads take.toml. Throws Error naming file and key for anything unknown or of another type; an
/// unknown key with those that would do.
TakeInfo read_take_info(const std::filesystem::path& file);

/// Writes take.toml.
void write_take_info(const TakeInfo& info, const std::filesystem::path& file);

}  // namespace tegata
