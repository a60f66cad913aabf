// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/manifold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tegata/mesh/edge_sides.h"

namespace tegata {
namespace {

constexpr std::uint32_t kNone = ~0u;

// The triangles without pairs that use the same corners in opposite order.
std::vector<Triangle> without_back_to_back(const std::vector<Triangle>& triangles) {
  struct Entry {
    Triangle sorted;
    bool is_even;  // permutation
    std::uint32_t index;
  };
  std::vector<Entry> entries;
  entries.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    Triangle t = triangles[i];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const bool is_even = t[1] < t[2];
    if (!is_even) std::swap(t[1], t[2]);
    entries.push_back({t, is_even, i});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.index < b.index;
  });
  std::vector<std::uint8_t> dropped(triangles.size(), 0);
  for (auto first = entries.begin(); first != entries.end();) {
    const auto last = std::find_if(
        first, entries.end(), [&](const Entry& entry) { return entry.sorted != first->sorted; });
    for (auto a = first; a != last; ++a) {
      for (auto b = first; b != last && dropped[a->index] == 0; ++b) {
        if (a->is_even && !b->is_even && dropped[b->index] == 0) {
          dropped[a->index] = dropped[b->index] = 1;
        }
      }
    }
    first = last;
  }
  std::vector<Triangle> kept;
  kept.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (dropped[i] == 0) kept.push_back(triangles[i]);
  }
  return kept;
}

// The angle around an edge at which a side's triangle lies. Angles grow towards the outside of a
// triangle whose side runs upwards, from the edge's lower vertex to the higher, and towards the
// inside of the others.
class AngleAround {
 public:
  AngleAround(const TriangleMesh& mesh, const TriangleSide& edge)
      : mesh_(mesh), origin_(mesh.vertices[edge.low]) {
    const Eigen::Vector3d axis = (mesh.vertices[edge.high] - origin_).normalized();
    x_ = axis.unitOrthogonal();
    y_ = axis.cross(x_);
  }
  double operator()(const TriangleSide& side) const {
    const Eigen::Vector3d apex =
        mesh_.vertices[vertex_at(mesh_, next_corner(next_corner(side.corner)))] - origin_;
    return std::atan2(apex.dot(y_), apex.dot(x_));
  }

 private:
  const TriangleMesh& mesh_;
  Eigen::Vector3d origin_, x_, y_;
};

// Calls split(upward side, downward side) for all but one of the pairs into which the triangles of
// an edge with more than two fall.
template <typename Split>
void pair_triangles(const TriangleMesh& mesh, std::vector<TriangleSide> sides, const Split& split) {
  const AngleAround angle(mesh, sides.front());
  const auto is_upward = [&](const TriangleSide& side) {
    return vertex_at(mesh, side.corner) == side.low;
  };
  while (sides.size() > 2) {
    // The narrowest piece of the inside: from a downward side on to an upward one.
    std::size_t best_up = 0, best_down = 0;
    double narrowest = 8.0;  // more than a full turn
    for (std::size_t up = 0; up < sides.size(); ++up) {
      for (std::size_t down = 0; down < sides.size(); ++down) {
        if (!is_upward(sides[up]) || is_upward(sides[down])) continue;
        double opening = angle(sides[up]) - angle(sides[down]);
        if (opening < 0.0) opening += 2.0 * std::numbers::pi;
        if (opening < narrowest) {
          narrowest = opening;
          best_up = up;
          best_down = down;
        }
      }
    }
    split(sides[best_up], sides[best_down]);
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(std::max(best_up, best_down)));
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(std::min(best_up, best_down)));
  }
}

// Gives every pair of triangles but one on each crowded edge a vertex in the edge's middle.
void divide_crowded_edges(TriangleMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> middles(mesh.triangles.size(), {kNone, kNone, kNone});
  bool any = false;
  for_each_edge(sides_by_edge(mesh), [&](auto first, auto last) {
    const auto count = last - first;
    const auto upward = std::count_if(first, last, [&](const TriangleSide& side) {
      return vertex_at(mesh, side.corner) == side.low;
    });
    if (count <= 2 || 2 * upward != count) return;
    pair_triangles(mesh, {first, last}, [&](const TriangleSide& up, const TriangleSide& down) {
      const auto vertex = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(0.5 * (mesh.vertices[up.low] + mesh.vertices[up.high]));
      if (!mesh.unproven.empty()) {
        mesh.unproven.push_back(std::max(mesh.unproven[up.low], mesh.unproven[up.high]));
      }
      if (!mesh.normals.empty()) {
        mesh.normals.push_back((mesh.normals[up.low] + mesh.normals[up.high]).stableNormalized());
      }
      middles[up.corner / 3][up.corner % 3] = middles[down.corner / 3][down.corner % 3] = vertex;
      any = true;
    });
  });
  if (!any) return;
  std::vector<Triangle> divided;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::vector<std::uint32_t> ring;
    std::size_t start = 0;  // a middle, from where no triangle of the fan is flat
    for (std::size_t i = 0; i < 3; ++i) {
      ring.push_back(mesh.triangles[t][i]);
      if (middles[t][i] == kNone) continue;
      start = ring.size();
      ring.push_back(middles[t][i]);
    }
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      divided.push_back(
          {ring[start], ring[(start + i) % ring.size()], ring[(start + i + 1) % ring.size()]});
    }
  }
  mesh.triangles = divided;
}

// Gives each fan of triangles around a vertex but the first a copy of the vertex.
void separate_fans(TriangleMesh& mesh) {
  DisjointSets corners = corners_by_fan(mesh, sides_by_edge(mesh));
  std::vector<std::uint32_t> first_fan(mesh.vertices.size(), kNone);
  std::vector<std::uint32_t> vertex_of_fan(3 * mesh.triangles.size(), kNone);
  std::vector<Triangle> separated = mesh.triangles;
  for (std::uint32_t corner = 0; corner < vertex_of_fan.size(); ++corner) {
    const std::uint32_t fan = corners.root(corner), vertex = vertex_at(mesh, corner);
    if (first_fan[vertex] == kNone) {
      first_fan[vertex] = fan;
      vertex_of_fan[fan] = vertex;
    }
    if (vertex_of_fan[fan] == kNone) {
      vertex_of_fan[fan] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(Eigen::Vector3d(mesh.vertices[vertex]));
      if (!mesh.unproven.empty()) mesh.unproven.push_back(std::uint8_t{mesh.unproven[vertex]});
      if (!mesh.normals.empty()) mesh.normals.push_back(Eigen::Vector3d(mesh.normals[vertex]));
    }
    separated[corner / 3][corner % 3] = vertex_of_fan[fan];
  }
  mesh.triangles = separated;
}

}  // namespace

TriangleMesh as_manifold(const TriangleMesh& mesh) {
  TriangleMesh manifold = mesh;
  manifold.triangles = without_back_to_back(mesh.triangles);
  divide_crowded_edges(manifold);
  separate_fans(manifold);
  return without_unused_vertices(manifold);
}

}  // namespace tegata
