// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a PLY mesh. A mesh that is read is sound, and its topology can be said.
#include <cstring>
#include <string_view>

#include "bytes.h"
#include "tegata/base/error.h"
#include "tegata/mesh/ply_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const tegata::TriangleMesh mesh = tegata::parse_ply(bytes, "input");
    tegata::check_mesh(mesh);
    tegata::inspect_topology(mesh);
  } catch (const tegata::Error& error) {
    tegata::require(std::strchr(error.what(), '\n') == nullptr, "an error of several lines");
  }
  return 0;
}
