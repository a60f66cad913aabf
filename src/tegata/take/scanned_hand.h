// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "tegata/hand/hand_model.h"

namespace tegata {

/// A surface without bones and where its joints are, all in one frame [m].
struct ScannedHand {
  std::string name;
  Side side = Side::right;
  TriangleMesh surface;
  std::array<Eigen::Vector3d, kKeypointCount> keypoints;  ///< joint centres and fingertips
};

/// Reads the TOML that docs/formats.md describes ("A scanned hand") and the mesh that it names.
/// Throws Error naming file and key for what is missing, unknown or of another type.
ScannedHand read_scanned_hand(const std::filesystem::path& file);

/// Gives a scan its bones (skeleton_from_keypoints.h) and links each vertex to the two nearest
/// (skin_links.h), as the paper did (III-B-2). Vertices of no triangle are left out, a surface that
/// is inside out is turned. Throws Error, beginning with the hand's name, where the joints are not
/// those of such a hand or lie outside the surface by more than their distance to a joint may be.
HandModel rigged(const ScannedHand& scan);

}  // namespace tegata
