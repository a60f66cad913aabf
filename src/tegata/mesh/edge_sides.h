// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Disjoint sets of 0 .. count - 1; a set's root is its lowest element.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t root(std::uint32_t element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// One side of a triangle. Corner c of triangle t has the number 3 t + c; a side has the number of
/// the corner at which it starts.
struct TriangleSide {
  std::uint32_t low = 0, high = 0;  ///< vertices, low <= high
  std::uint32_t corner = 0;
  bool same_edge(const TriangleSide& other) const { return low == other.low && high == other.high; }
};

inline std::uint32_t next_corner(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

inline std::uint32_t vertex_at(const TriangleMesh& mesh, std::uint32_t corner) {
  return mesh.triangles[corner / 3][corner % 3];
}

/// All sides of a checked mesh, those of one edge next to each other.
std::vector<TriangleSide> sides_by_edge(const TriangleMesh& mesh);

/// Calls visit(first, last) with the run of sides of each edge.
template <typename Visit>
void for_each_edge(const std::vector<TriangleSide>& sides, const Visit& visit) {
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(
        first, sides.end(), [&](const TriangleSide& side) { return !side.same_edge(*first); });
    visit(first, last);
    first = last;
  }
}

/// The corners of all triangles; those at one vertex are in one set where edges at that vertex join
/// their triangles.
DisjointSets corners_by_fan(const TriangleMesh& mesh, const std::vector<TriangleSide>& sides);

}  // namespace tegata
