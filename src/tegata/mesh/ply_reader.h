// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// The mesh in the bytes of a PLY file, as read_ply() of mesh_file.h has it. `file` is what errors
/// call it.
TriangleMesh parse_ply(std::string_view bytes, const std::string& file);

}  // namespace tegata
