// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as the TOML of a board, ours or Caliscope's. A board that is read can be drawn.
#include "memory_file.h"
#include "reading.h"
#include "tegata/pipeline/calibrate_take.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] {
    const tegata::Board board = tegata::read_board(file.path());
    for (const Eigen::Vector3d& point : tegata::board_points(board)) {
      tegata::require(point.allFinite(), "a point of a board that is nowhere");
    }
  });
  return 0;
}
