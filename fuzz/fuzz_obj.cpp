// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as an OBJ mesh. A mesh that is read is sound.
#include "memory_file.h"
#include "reading.h"
#include "tegata/mesh/mesh_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] { tegata::check_mesh(tegata::read_obj(file.path())); });
  return 0;
}
