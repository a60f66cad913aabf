// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as truth.json.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/truth.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] {
    for (const tegata::TruthFrame& frame : tegata::read_truth_json(file.path()).frames) {
      for (const Eigen::Vector3d& keypoint : frame.keypoints) {
        tegata::require(keypoint.allFinite(), "a keypoint that is nowhere");
      }
    }
  });
  return 0;
}
