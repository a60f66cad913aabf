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
constexpr float kLeastShare = 1.0f / 256.0f;
constexpr std::uint32_t kNoVertex = ~0u;

class SurfaceExtraction {
 public:
  explicit SurfaceExtraction(const SparseField& field)
      : field_(field), vertex_on_edge_({kNoVertex, kNoVertex, kNoVertex}) {}

  TriangleMesh run() {
    const std::size_t expected = field_.leaves.size() + field_.leaves.size() / 16;
    mesh_.vertices.reserve(expected);
    sums_.reserve(expected);
    mesh_.triangles.reserve(2 * expected);
    const bool has_marks = std::any_of(field_.leaves.begin(), field_.leaves.end(),
                                       [](const OctreeLeaf& leaf) { return leaf.unproven; });
    const std::array<CubeCase, 256>& cases = cube_cases();
    for (const OctreeLeaf& leaf : field_.leaves) {
      unsigned inside = 0;
      for (unsigned i = 0; i < 8; ++i) inside |= (leaf.field[i] > 0.0f ? 1u : 0u) << i;
      const CubeCase& cube = cases[inside];
      for (const std::uint8_t edge : cube.edges) add_crossing(leaf, edge);
      for (std::size_t i = 0; i < cube.centered_loops.size(); ++i) {
        local_[12 + i] = add_middle(cube.centered_loops[i]);
      }
      for (const auto& t : cube.triangles) {
        mesh_.triangles.push_back({local_[t[0]], local_[t[1]], local_[t[2]]});
      }
      if (!has_marks) continue;
      mesh_.unproven.resize(mesh_.vertices.size(), 0);
      if (leaf.unproven) mark(cube);
    }
    finish_normals();
    return std::move(mesh_);
  }

 private:
  // Looks up or makes the vertex on an edge of a leaf, and adds what the leaf knows of its normal.
  void add_crossing(const OctreeLeaf& leaf, std::uint8_t number) {
    const CubeEdge& edge = edges_[number];
    const float low = leaf.field[edge.low_corner], high = leaf.field[edge.high_corner];
    const float crossing = low / (low - high);
    const float share = crossing > kLeastShare ? std::min(crossing, 1.0f - kLeastShare)
                                               : kLeastShare;  // also where it is not a number
    const LatticeIndex at = {leaf.index[0] + (edge.low_corner & 1),
                             leaf.index[1] + (edge.low_corner >> 1 & 1),
                             leaf.index[2] + (edge.low_corner >> 2)};
    std::uint32_t& vertex = vertex_on_edge_[at][edge.axis];
    if (vertex == kNoVertex) {
      Eigen::Vector3d position(at[0], at[1], at[2]);
      position[edge.axis] += static_cast<double>(share);
      vertex = add_vertex(field_.origin + field_.cell_size * position);
    }
    subtract_gradient(leaf, edge, share, sums_[vertex]);
    local_[number] = vertex;
  }

  std::uint32_t add_middle(const std::vector<std::uint8_t>& loop) {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    for (const std::uint8_t edge : loop) {
      offset += mesh_.vertices[local_[edge]] - field_.origin;
      normal += sums_[local_[edge]];
    }
    const std::uint32_t vertex =
        add_vertex(field_.origin + offset / static_cast<double>(loop.size()));
    sums_.back() = normal;
    return vertex;
  }

  std::uint32_t add_vertex(const Eigen::Vector3d& position) {
    mesh_.vertices.push_back(position);
    sums_.push_back(Eigen::Vector3f::Zero());
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  // The gradient, per cell, of the leaf's trilinear field at a point of an edge. Summed over the
  // four leaves around the edge, the slopes across it become central differences.
  static void subtract_gradient(const OctreeLeaf& leaf, const CubeEdge& edge, float share,
                                Eigen::Vector3f& sum) {
    const unsigned low = edge.low_corner, high = edge.high_corner;
    sum[edge.axis] -= leaf.field[high] - leaf.field[low];
    for (unsigned step = 1; step < 3; ++step) {
      const unsigned axis = (edge.axis + step) % 3, across = 1u << axis;
      const float slope = (1.0f - share) * (leaf.field[low ^ across] - leaf.field[low]) +
                          share * (leaf.field[high ^ across] - leaf.field[high]);
      sum[axis] -= (low & across) == 0 ? slope : -slope;
    }
  }

  void mark(const CubeCase& cube) {
    for (const auto& t : cube.triangles) {
      for (const std::uint8_t corner : t) mesh_.unproven[local_[corner]] = 1;
    }
  }

  // Makes unit vectors of the sums of gradients; where they say nothing the triangles do.
  void finish_normals() {
    std::vector<Eigen::Vector3d> by_triangles;
    mesh_.normals.resize(sums_.size());
    for (std::size_t v = 0; v < sums_.size(); ++v) {
      const Eigen::Vector3d sum = sums_[v].cast<double>();
      const double length = std::sqrt(sum.squaredNorm());
      if (length > 0.0 && std::isfinite(length)) {
        mesh_.normals[v] = sum / length;
      } else {
        if (by_triangles.empty()) by_triangles = vertex_normals(mesh_);
        mesh_.normals[v] = by_triangles[v];
      }
    }
  }

  const SparseField& field_;
  const std::array<CubeEdge, 12>& edges_ = cube_edges();
  LatticeMap<std::array<std::uint32_t, 3>> vertex_on_edge_;  // by the edge's lower end and axis
  std::array<std::uint32_t, 16> local_{};  // vertices of the current leaf, as CubeCase numbers them
  std::vector<Eigen::Vector3f> sums_;      // of the field's falls, by vertex
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh extract_isosurface(const SparseField& field) { return SurfaceExtraction(field).run(); }

}  // namespace tegata
