// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tegata/calibrate/board.h"
#include "tegata/camera/camera.h"

namespace tegata {

/// The points of a view as they lie on the board [m].
std::vector<Eigen::Vector3d> points_of(const BoardView& view,
                                       const std::vector<Eigen::Vector3d>& board);

/// Sets focal lengths and one radial coefficient, with the centre in the middle, from views of a
/// board by one camera, at most 40 of them, spread evenly.
void start_intrinsics(Camera& camera, const std::vector<BoardView>& views,
                      const std::vector<Eigen::Vector3d>& board);

/// Where the board stands before a camera; nothing where its points say nothing.
std::optional<Rigid3d> start_pose(const Camera& camera, const BoardView& view,
                                  const std::vector<Eigen::Vector3d>& board);

/// camera_from_board by frame and camera.
using BoardPoses = std::vector<std::vector<std::optional<Rigid3d>>>;

/// Sets the cameras' poses along the tree of the links with the most frames; each link is the one
/// of its frames' relative poses that is nearest to all. Camera 0 is the world. Throws Error naming
/// cameras that nothing links.
void start_extrinsics(CameraRig& rig, const BoardPoses& poses);

}  // namespace tegata
