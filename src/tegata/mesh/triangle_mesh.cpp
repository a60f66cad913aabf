// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/triangle_mesh.h"

#include <algorithm>
#include <cstddef>

#include "tegata/base/error.h"
#include "tegata/mesh/edge_sides.h"

namespace tegata {
namespace {

DisjointSets pieces(const TriangleMesh& mesh, const std::vector<TriangleSide>& sides) {
  DisjointSets triangles(mesh.triangles.size());
  for_each_edge(sides, [&](auto first, auto last) {
    for (auto side = first + 1; side != last; ++side) {
      triangles.unite(first->corner / 3, side->corner / 3);
    }
  });
  return triangles;
}

// Whether the triangles around each vertex are joined to one another by edges at that vertex.
bool has_one_fan_a_vertex(const TriangleMesh& mesh, const std::vector<TriangleSide>& sides) {
  DisjointSets corners = corners_by_fan(mesh, sides);
  std::vector<std::uint8_t> seen(mesh.vertices.size(), 0);
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    if (corners.root(corner) != corner) continue;
    std::uint8_t& fan = seen[vertex_at(mesh, corner)];
    if (fan != 0) return false;
    fan = 1;
  }
  return true;
}

}  // namespace

std::vector<Eigen::Vector3d> vertex_normals(const TriangleMesh& mesh) {
  constexpr double kCancelled = 1e-12;
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    const Eigen::Vector3d normal = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    const double area = normal.norm();
    for (const std::uint32_t v : t) {
      normals[v] += normal;
      areas[v] += area;
    }
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const double length = normals[v].norm();
    if (length > kCancelled * areas[v]) {
      normals[v] /= length;
    } else {
      normals[v].setZero();
    }
  }
  return normals;
}

double enclosed_volume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  // Tetrahedra are measured from a vertex, so that nothing is lost far from the origin.
  const Eigen::Vector3d& apex = mesh.vertices.front();
  double sixfold = 0.0;
  for (const Triangle& t : mesh.triangles) {
    sixfold += (mesh.vertices[t[0]] - apex)
                   .dot((mesh.vertices[t[1]] - apex).cross(mesh.vertices[t[2]] - apex));
  }
  return sixfold / 6.0;
}

double surface_area(const TriangleMesh& mesh) {
  double twofold = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    twofold += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
  }
  return 0.5 * twofold;
}

Eigen::AlignedBox3d bounding_box(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

MeshTopology inspect_topology(const TriangleMesh& mesh) {
  check_mesh(mesh);
  MeshTopology topology{.closed = true, .oriented = true, .manifold = true};
  const std::vector<TriangleSide> sides = sides_by_edge(mesh);
  int edge_count = 0;
  for_each_edge(sides, [&](auto first, auto last) {
    const auto count = last - first;
    const auto upward = std::count_if(first, last, [&](const TriangleSide& side) {
      return vertex_at(mesh, side.corner) == side.low;
    });
    ++edge_count;
    topology.closed &= count >= 2;
    topology.oriented &= count == 1 || 2 * upward == count;
    topology.manifold &= count <= 2 && first->low != first->high;
  });
  topology.manifold = topology.manifold && has_one_fan_a_vertex(mesh, sides);

  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = 1;
  }
  const auto vertex_count = std::count(used.begin(), used.end(), std::uint8_t{1});
  topology.euler_number =
      static_cast<int>(vertex_count) - edge_count + static_cast<int>(mesh.triangles.size());
  DisjointSets triangles = pieces(mesh, sides);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (triangles.root(t) == t) ++topology.component_count;
  }
  return topology;
}

void check_mesh(const TriangleMesh& mesh) {
  const std::size_t vertex_count = mesh.vertices.size();
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (!mesh.vertices[v].allFinite()) {
      throw Error("mesh: vertex ", v, " is (", mesh.vertices[v].transpose(),
                  "), expected finite numbers");
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v >= vertex_count) {
        throw Error("mesh: triangle ", t, " uses vertex ", v, ", expected 0 to ", vertex_count,
                    " - 1");
      }
    }
  }
  if (!mesh.normals.empty() && mesh.normals.size() != vertex_count) {
    throw Error("mesh: got ", mesh.normals.size(), " normals, expected none or ", vertex_count);
  }
  if (!mesh.unproven.empty() && mesh.unproven.size() != vertex_count) {
    throw Error("mesh: got ", mesh.unproven.size(), " marks, expected none or ", vertex_count);
  }
}

TriangleMesh without_unused_vertices(const TriangleMesh& mesh) {
  constexpr std::uint32_t kUnused = ~0u;
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) new_index[v] = 0;
  }
  if (std::find(new_index.begin(), new_index.end(), kUnused) == new_index.end()) return mesh;
  TriangleMesh compact;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (new_index[v] == kUnused) continue;
    new_index[v] = static_cast<std::uint32_t>(compact.vertices.size());
    compact.vertices.push_back(mesh.vertices[v]);
    if (!mesh.normals.empty()) compact.normals.push_back(mesh.normals[v]);
    if (!mesh.unproven.empty()) compact.unproven.push_back(mesh.unproven[v]);
  }
  compact.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    compact.triangles.push_back({new_index[t[0]], new_index[t[1]], new_index[t[2]]});
  }
  return compact;
}

}  // namespace tegata
