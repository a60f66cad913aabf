// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// `count` points on a mesh, spread evenly by area whatever the density of its vertices; the same
/// for the same mesh. The mesh must have an area.
std::vector<Eigen::Vector3d> sample_surface(const TriangleMesh& mesh, std::size_t count);

/// Mean distance [m] from the fitted surface to the true one and back, averaged over the two
/// directions, over 5000 points of each. Only points in front of `wrist_plane` (positive side)
/// count, for both surfaces; they are measured against the whole of the other. A fitted surface
/// that lies behind the plane altogether counts whole. Throws Error where either has no triangles
/// or the truth lies behind the plane.
double surface_error(const TriangleMesh& fitted, const TriangleMesh& truth,
                     const Eigen::Hyperplane<double, 3>& wrist_plane);

/// Mean distance [m] to the found surface of an object from the true one, over what of it lies
/// within `reach` [m] of the hand's surface: what a hand wraps it can tell of, of the rest nothing.
/// Nothing where the hand is not so near anywhere. All three in one frame.
std::optional<double> held_object_error(const TriangleMesh& found, const TriangleMesh& truth,
                                        const TriangleMesh& hand, double reach);

/// Mean distance [m] of corresponding vertices; nothing where the two have not the same triangles.
std::optional<double> vertex_error(const TriangleMesh& fitted, const TriangleMesh& truth);

}  // namespace tegata
