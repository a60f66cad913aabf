// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as result.json.
#include <cmath>

#include "memory_file.h"
#include "reading.h"
#include "tegata/take/result.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] {
    const tegata::Result result = tegata::read_result_json(file.path());
    tegata::require(result.grasp_angles.allFinite(), "angles that are not finite");
    for (const tegata::ResultFrame& frame : result.frames) {
      if (!frame.pose) continue;
      const Eigen::Quaterniond& turn = frame.pose->world_from_hand.rotation;
      tegata::require(std::abs(turn.norm() - 1.0) < 1e-6, "a rotation that is none");
    }
  });
  return 0;
}
