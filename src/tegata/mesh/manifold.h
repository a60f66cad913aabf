// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// The same surface as a 2-manifold. Two triangles that lie back to back on the same corners are
/// dropped. Where more than two triangles meet in an edge, those that bound the same piece of the
/// inside stay together and the other pairs get a vertex of their own in the middle of the edge; a
/// vertex that joins several fans is doubled. Normals and marks are carried over. A closed,
/// oriented mesh stays so; edges with an odd number of triangles are left as they are.
TriangleMesh as_manifold(const TriangleMesh& mesh);

}  // namespace tegata
