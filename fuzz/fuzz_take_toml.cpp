// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as take.toml.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/take_info.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] {
    const tegata::TakeInfo info = tegata::read_take_info(file.path());
    tegata::require(info.fps > 0.0 && info.metres_per_unit > 0.0, "a number that is not positive");
  });
  return 0;
}
