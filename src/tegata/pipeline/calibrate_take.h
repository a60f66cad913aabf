// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "tegata/base/observer.h"
#include "tegata/calibrate/board_calibration.h"

namespace tegata {

struct CalibrateTakeOptions {
  std::filesystem::path board_file;  ///< empty: board.toml or charuco.toml in the folder
  std::size_t most_frames = 150;     ///< spread evenly over the recording
  /// A calibration whose focal lengths, centres and distortions are kept, by the cameras' names.
  std::filesystem::path intrinsics_file;
  int threads = 0;
};

/// Reads a board from a TOML of ours or of Caliscope's; docs/formats.md describes both.
Board read_board(const std::filesystem::path& file);

/// The calibration whose lenses are kept: what was asked for; else intrinsics.toml or Caliscope's
/// camera_array.toml in the folder; nothing where there is none or where "find" was asked for.
std::filesystem::path find_intrinsics(const std::filesystem::path& folder,
                                      const std::string& asked);

/// Finds the board in the pictures of a folder: images/<camera>/, videos/<camera>.mp4, or videos
/// beside the board's file. Frames pair up as in a take.
BoardRecording read_board_recording(const std::filesystem::path& folder,
                                    const CalibrateTakeOptions& options, const Observer& observer);

}  // namespace tegata
