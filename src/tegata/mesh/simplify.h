// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Edge collapse by quadric error (meshoptimizer) to `triangle_count` triangles or few more, or
/// until the next collapse would have a quadric error (the root mean square of distances to the
/// planes that it stands for) above `largest_error` [m]. A closed, oriented 2-manifold stays one,
/// though thin necks may break. Vertices that stay keep their normals and marks. A mesh that has no
/// more triangles than asked for comes back as it is.
TriangleMesh simplify(const TriangleMesh& mesh, std::size_t triangle_count,
                      double largest_error = std::numeric_limits<double>::infinity());

}  // namespace tegata
