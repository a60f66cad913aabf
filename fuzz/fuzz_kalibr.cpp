// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as one file with the cameras of another tool, of which Kalibr's camchain is the seed:
// its content says which tool it is.
#include "memory_file.h"
#include "reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_rigs_or_refuse([&](const tegata::CalibrationImportOptions& options) {
    return tegata::import_calibration(file.path(), options).rig;
  });
  return 0;
}
