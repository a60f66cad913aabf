// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Garland and Heckbert, Surface Simplification Using Quadric Error Metrics (1997), as meshoptimizer
// implements it.
#include "tegata/mesh/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>

#include "tegata/base/error.h"
#include "tegata/mesh/manifold.h"

namespace tegata {
namespace {

// The mesh that three indices each make of a mesh's vertices, and no others.
TriangleMesh with_triangles(const TriangleMesh& mesh, const std::vector<unsigned int>& indices) {
  constexpr std::uint32_t kUnused = ~0u;
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
  TriangleMesh part;
  part.triangles.reserve(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    Triangle& triangle = part.triangles.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t v = indices[i + corner];
      if (new_index[v] == kUnused) {
        new_index[v] = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[v]);
        if (!mesh.normals.empty()) part.normals.push_back(mesh.normals[v]);
        if (!mesh.unproven.empty()) part.unproven.push_back(mesh.unproven[v]);
      }
      triangle[corner] = new_index[v];
    }
  }
  return part;
}

}  // namespace

TriangleMesh simplify(const TriangleMesh& mesh, std::size_t triangle_count, double largest_error) {
  check_mesh(mesh);
  if (!(largest_error >= 0.0)) {
    throw Error("simplify: got a largest error of ", largest_error, " m, expected 0 or more");
  }
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
  // Its errors are shares of the mesh's size.
  const double size = static_cast<double>(
      meshopt_simplifyScale(positions.data(), mesh.vertices.size(), 3 * sizeof(float)));
  const double share =
      std::min(largest_error / size, static_cast<double>(std::numeric_limits<float>::max()));
  const std::size_t index_count = 3 * mesh.triangles.size();
  static_assert(sizeof(Triangle) == 3 * sizeof(unsigned int));
  std::vector<unsigned int> indices(index_count);
  const std::size_t kept =
      meshopt_simplify(indices.data(), mesh.triangles.front().data(), index_count, positions.data(),
                       mesh.vertices.size(), 3 * sizeof(float), 3 * triangle_count,
                       static_cast<float>(share), 0, nullptr);
  indices.resize(kept);
  // The library does not keep two collapses from leaving an edge to four triangles.
  return as_manifold(with_triangles(mesh, indices));
}

}  // namespace tegata
