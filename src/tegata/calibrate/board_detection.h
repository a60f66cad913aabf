// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tegata/calibrate/board.h"
#include "tegata/image/image.h"

namespace tegata {

/// Finds a board in pictures; may be used from several threads.
class BoardDetector {
 public:
  /// Throws Error where there is no such board or dictionary.
  explicit BoardDetector(const Board& board);
  ~BoardDetector();
  BoardDetector(const BoardDetector&) = delete;
  BoardDetector& operator=(const BoardDetector&) = delete;

  /// The board's points to sub-pixel position; none where it was not found. Pictures of one channel
  /// are stretched to their range first, small ones enlarged.
  BoardView detect(const CameraImage& picture) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tegata
