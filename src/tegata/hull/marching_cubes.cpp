// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/marching_cubes.h"

#include <algorithm>
#include <cmath>

#include "tegata/hull/cube_cases.h"
#include "tegata/hull/lattice_map.h"

namespace tegata {
namespace {

// Vertices keep this share of an edge away from its ends, so that no two fall onto one corner of
// the lattice where the field is zero there.
constexpr double kLeastShare = 1.0 / 256.0;
constexpr std::uint32_t kNoVertex = ~0u;

class SurfaceExtraction {
 public:
  explicit SurfaceExtraction(const SparseField& field)
      : field_(field), vertex_on_edge_({kNoVertex, kNoVertex, kNoVertex}) {}

  TriangleMesh run() {
    mesh_.vertices.reserve(field_.leaves.size() + field_.leaves.size() / 4);
    mesh_.normals.reserve(mesh_.vertices.capacity());
    mesh_.triangles.reserve(2 * mesh_.vertices.capacity());
    const bool has_marks = std::any_of(field_.leaves.begin(), field_.leaves.end(),
                                       [](const OctreeLeaf& leaf) { return leaf.unproven; });
    for (const OctreeLeaf& leaf : field_.leaves) {
      unsigned inside = 0;
      for (unsigned i = 0; i < 8; ++i) inside |= (leaf.field[i] > 0.0f ? 1u : 0u) << i;
      add_vertices(leaf, inside);
      for (const auto& t : cube_cases()[inside].triangles) {
        mesh_.triangles.push_back({local_[t[0]], local_[t[1]], local_[t[2]]});
      }
      if (!has_marks) continue;
      mesh_.unproven.resize(mesh_.vertices.size(), 0);
      if (leaf.unproven) mark(cube_cases()[inside]);
    }
    finish_normals();
    return std::move(mesh_);
  }

 private:
  // Looks up or makes the vertices of one leaf, and adds what the leaf knows of their normals.
  void add_vertices(const OctreeLeaf& leaf, unsigned inside) {
    for (std::size_t e = 0; e < 12; ++e) {
      const CubeEdge& edge = cube_edges()[e];
      if ((inside >> edge.low_corner & 1u) == (inside >> edge.high_corner & 1u)) continue;
      const double low = leaf.field[edge.low_corner], high = leaf.field[edge.high_corner];
      const double crossing = low / (low - high);
      const double share = crossing > kLeastShare ? std::min(crossing, 1.0 - kLeastShare)
                                                  : kLeastShare;  // also where it is not a number
      LatticeIndex at = leaf.index;
      for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += edge.low_corner >> axis & 1;
      std::uint32_t& vertex = vertex_on_edge_[at][edge.axis];
      if (vertex == kNoVertex) {
        Eigen::Vector3d position(at[0], at[1], at[2]);
        position[edge.axis] += share;
        vertex = add_vertex(field_.origin + field_.cell_size * position);
      }
      mesh_.normals[vertex] -= gradient_on(leaf, edge, share);
      local_[e] = vertex;
    }
    const auto& loops = cube_cases()[inside].centered_loops;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
      for (const std::uint8_t edge : loops[i]) {
        sum += mesh_.vertices[local_[edge]] - field_.origin;
        normal += mesh_.normals[local_[edge]];
      }
      local_[12 + i] = add_vertex(field_.origin + sum / static_cast<double>(loops[i].size()));
      mesh_.normals.back() = normal;
    }
  }

  std::uint32_t add_vertex(const Eigen::Vector3d& position) {
    mesh_.vertices.push_back(position);
    mesh_.normals.push_back(Eigen::Vector3d::Zero());
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  // The gradient, per cell, of the leaf's trilinear field at a point of an edge. Summed over the
  // four leaves around the edge, the slopes across it become central differences.
  static Eigen::Vector3d gradient_on(const OctreeLeaf& leaf, const CubeEdge& edge, double share) {
    const auto value = [&](unsigned corner) { return static_cast<double>(leaf.field[corner]); };
    const unsigned low = edge.low_corner, high = edge.high_corner;
    Eigen::Vector3d gradient;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned across = 1u << axis;
      if (axis == edge.axis) {
        gradient[axis] = value(high) - value(low);
      } else {
        const double slope = (1.0 - share) * (value(low ^ across) - value(low)) +
                             share * (value(high ^ across) - value(high));
        gradient[axis] = (low & across) == 0 ? slope : -slope;
      }
    }
    return gradient;
  }

  void mark(const CubeCase& cube) {
    for (const auto& t : cube.triangles) {
      for (const std::uint8_t corner : t) mesh_.unproven[local_[corner]] = 1;
    }
  }

  // Makes the sums of gradients unit vectors; where they say nothing the triangles do.
  void finish_normals() {
    std::vector<Eigen::Vector3d> by_triangles;
    for (std::size_t v = 0; v < mesh_.normals.size(); ++v) {
      const double length = mesh_.normals[v].norm();
      if (length > 0.0 && std::isfinite(length)) {
        mesh_.normals[v] /= length;
      } else {
        if (by_triangles.empty()) by_triangles = vertex_normals(mesh_);
        mesh_.normals[v] = by_triangles[v];
      }
    }
  }

  const SparseField& field_;
  LatticeMap<std::array<std::uint32_t, 3>> vertex_on_edge_;  // by the edge's lower end and axis
  std::array<std::uint32_t, 16> local_{};  // vertices of the current leaf, as CubeCase numbers them
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh extract_isosurface(const SparseField& field) { return SurfaceExtraction(field).run(); }

}  // namespace tegata
