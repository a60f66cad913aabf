// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tegata/calibrate/board.h"
#include "tegata/camera/camera.h"

namespace tegata {

/// What some cameras saw of a board in some moments.
struct BoardRecording {
  Board board;
  std::vector<Camera> cameras;  ///< name and size; the rest as well where it is known
  std::vector<std::string> frame_names;
  std::vector<std::vector<BoardView>> views;  ///< by frame and camera; empty where not seen
};

struct BoardCalibrationOptions {
  /// The cameras' focal lengths, centres and distortions are known and stay: only poses are found.
  bool known_intrinsics = false;
  std::size_t fewest_points = 6;  ///< that a view must have to count
  std::size_t fewest_views = 5;   ///< that a camera must have
};

/// A view that contradicts the others and was left out.
struct OutlierView {
  std::string camera, frame;
  double rms = 0.0;  ///< [px]
};

struct CameraResiduals {
  std::size_t views = 0, points = 0;  ///< that were used
  double rms = 0.0;                   ///< root of the mean squared distance [px]
  double coverage = 0.0;              ///< share of an 8 x 6 grid of the picture with a point in it
  /// Standard deviation of the direction in which the camera looks, as the views leave its lens's
  /// centre open if a view's errors go together [rad]. 0 where lenses are known.
  double direction_deviation = 0.0;
};

struct BoardCalibration {
  CameraRig rig;  ///< in the order of the recording; metres; the first name's camera is the world
  std::map<std::string, CameraResiduals> cameras;
  std::vector<OutlierView> outliers;
  double rms = 0.0;                       ///< over all points [px]
  std::vector<Rigid3d> world_from_board;  ///< by frame, where `frame_used`
  std::vector<bool> frame_used;
};

/// Calibrates cameras that need not all see the board at once, as long as views link them: each
/// camera alone (Zhang 2000), poses along the strongest links, then everything at once by bundle
/// adjustment with a robust loss; views that contradict the rest are left out and named. The result
/// does not depend on the order of the cameras. Throws Error naming cameras with too few views and
/// those that no view links to the others.
BoardCalibration calibrate_rig(const BoardRecording& recording,
                               const BoardCalibrationOptions& options);

}  // namespace tegata
