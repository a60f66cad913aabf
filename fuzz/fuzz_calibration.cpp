// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as calibration.toml. A rig that is read has cameras that can be used.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/calibration_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] { tegata::require_usable(tegata::read_calibration(file.path())); });
  return 0;
}
