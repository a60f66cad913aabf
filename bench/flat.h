// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dense_field.h"
#include "peers/peers.h"
#include "tegata/hull/visual_hull.h"

namespace tegata::bench {

/// Ours as the peers take it.
std::vector<FlatView> flat(const std::vector<HullView>& views);
/// The cube that an octree divided.
FlatCube flat_cube(const SparseField& field);
FlatMesh flat(const TriangleMesh& mesh);

/// meshopt_simplify alone, on what it takes, without any care for what comes out.
std::vector<std::uint32_t> meshoptimizer_triangles(const FlatMesh& mesh,
                                                   std::size_t triangle_count);

TriangleMesh from_flat(const FlatMesh& mesh);

}  // namespace tegata::bench
