// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as the TOML of a scanned hand, whose seed names a mesh. A scan is given bones, or it is
// said why it cannot.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/scanned_hand.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse(
      [&] { tegata::check_hand(tegata::rigged(tegata::read_scanned_hand(file.path()))); });
  return 0;
}
