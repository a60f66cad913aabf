// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Garland and Heckbert, Surface Simplification Using Quadric Error Metrics (1997), as meshoptimizer
// implements it.
#include "tegata/mesh/simplify.h"

#include <meshoptimizer.h>

#include <limits>

#include "tegata/mesh/manifold.h"

namespace tegata {

TriangleMesh simplify(const TriangleMesh& mesh, std::size_t triangle_count) {
  check_mesh(mesh);
  if (mesh.triangles.size() <= triangle_count) return mesh;

  // The library takes single precision: measured from the middle of the mesh, a scene far from the
  // origin loses nothing.
  const Eigen::Vector3d middle = bounding_box(mesh).center();
  std::vector<float> positions;
  positions.reserve(3 * mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3f offset = (vertex - middle).cast<float>();
    positions.insert(positions.end(), {offset.x(), offset.y(), offset.z()});
  }
  const std::size_t index_count = 3 * mesh.triangles.size();
  static_assert(sizeof(Triangle) == 3 * sizeof(unsigned int));
  std::vector<unsigned int> indices(index_count);
  const std::size_t kept =
      meshopt_simplify(indices.data(), mesh.triangles.front().data(), index_count, positions.data(),
                       mesh.vertices.size(), 3 * sizeof(float), 3 * triangle_count,
                       std::numeric_limits<float>::max(), 0, nullptr);

  TriangleMesh coarse;
  coarse.vertices = mesh.vertices;
  coarse.unproven = mesh.unproven;
  coarse.triangles.reserve(kept / 3);
  for (std::size_t i = 0; i < kept; i += 3) {
    coarse.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  }
  // The library does not keep two collapses from leaving an edge to four triangles.
  coarse = as_manifold(coarse);
  coarse.normals = vertex_normals(coarse);
  return coarse;
}

}  // namespace tegata
