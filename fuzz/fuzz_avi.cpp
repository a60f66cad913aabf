// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as an AVI: its index says where pictures are. What decodes them is FFmpeg's and
// OpenCV's, whose own faults are not for here.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/avi_index.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile bytes(data, size);
  const tegata::AviIndex index = tegata::read_avi_index(bytes.path());
  tegata::require(index.found.size() <= index.count && index.count <= size / 16,
                  "more pictures than there are entries");
  for (std::size_t i = 0; i < index.found.size(); ++i) {
    tegata::require(index.found[i] < index.count && (i == 0 || index.found[i - 1] < index.found[i]),
                    "pictures out of order");
  }
  return 0;
}
