// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Edge collapse by quadric error (meshoptimizer) to `triangle_count` triangles or few more; a
/// closed, oriented 2-manifold stays one, though thin necks may break. Marks are carried over and
/// normals made anew from the triangles. A mesh that has no more triangles than asked for comes
/// back as it is.
TriangleMesh simplify(const TriangleMesh& mesh, std::size_t triangle_count);

}  // namespace tegata
