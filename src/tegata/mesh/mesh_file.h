// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Writes a binary little-endian PLY: float vertices [m], normals and marks where the mesh has
/// them, and a `confidence` where there is one a vertex. Throws Error naming the file where it
/// cannot be written whole.
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& file,
               std::span<const float> confidence = {});

/// Writes a Wavefront OBJ: v lines [m], vn lines where the mesh has normals, and f lines. Throws
/// Error naming the file where it cannot be written whole.
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& file);

/// Reads a PLY (ascii or binary little-endian) with x y z, faces of any size (fanned into
/// triangles), and nx ny nz and `unproven` if present; other properties and elements are skipped.
/// Throws Error naming the file and what is wrong in it.
TriangleMesh read_ply(const std::filesystem::path& file);

/// Reads the v and f lines of a Wavefront OBJ; faces of any size are fanned into triangles.
/// Throws Error naming the file, the line and what is wrong in it.
TriangleMesh read_obj(const std::filesystem::path& file);

}  // namespace tegata
