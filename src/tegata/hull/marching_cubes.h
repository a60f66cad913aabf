// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/hull/octree.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// The zero level of a field known at its leaves (Lorensen and Cline 1987), with positions
/// interpolated along the cells' edges. Closed, consistently oriented (outwards) and 2-manifold for
/// every field: on an ambiguous face the inside corners are kept apart, which is the same rule for
/// both cells that share it, and no triangle edge runs within a cell's face. Normals come from the
/// field's gradient; leaves that are unproven mark their vertices.
TriangleMesh extract_isosurface(const SparseField& field);

}  // namespace tegata
