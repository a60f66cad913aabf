// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace tegata {

/// Three vertex indices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A surface of triangles over shared vertices, in metres.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
  /// Empty, or one unit vector a vertex, pointing outwards.
  std::vector<Eigen::Vector3d> normals;
  /// Empty, or one a vertex: 1 where the surface is there only because a pixel was unknown.
  std::vector<std::uint8_t> unproven;
};

/// One unit normal a vertex: the sum of its triangles' normals weighted by area. Zero where the
/// triangles of a vertex cancel out or have no area.
std::vector<Eigen::Vector3d> vertex_normals(const TriangleMesh& mesh);

/// The volume that a closed mesh encloses [m^3]; negative if it is turned inside out.
double enclosed_volume(const TriangleMesh& mesh);

/// The area of all triangles [m^2].
double surface_area(const TriangleMesh& mesh);

/// The box around all vertices; empty for a mesh without vertices.
Eigen::AlignedBox3d bounding_box(const TriangleMesh& mesh);

/// What can be said of a mesh from its triangles alone.
struct MeshTopology {
  bool closed = false;      ///< every edge has two triangles or more
  bool oriented = false;    ///< neighbours run along their common edge in opposite directions
  bool manifold = false;    ///< no edge has more than two triangles, no vertex more than one fan
  int euler_number = 0;     ///< vertices in use - edges + triangles
  int component_count = 0;  ///< pieces connected by edges
};
MeshTopology inspect_topology(const TriangleMesh& mesh);

/// Throws Error unless all vertices are finite, all indices are in range, and normals and marks are
/// absent or one a vertex.
void check_mesh(const TriangleMesh& mesh);

/// The mesh without the vertices that no triangle uses; the others keep their order, normals and
/// marks.
TriangleMesh without_unused_vertices(const TriangleMesh& mesh);

}  // namespace tegata
