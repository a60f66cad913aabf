// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/edge_sides.h"

#include <utility>

namespace tegata {

// Sides are counted into their lower vertices, then sorted among the few that share one.
std::vector<TriangleSide> sides_by_edge(const TriangleMesh& mesh) {
  const auto corner_count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  std::vector<std::uint32_t> start(mesh.vertices.size() + 1, 0);
  const auto make_side = [&](std::uint32_t corner) {
    const std::uint32_t a = vertex_at(mesh, corner), b = vertex_at(mesh, next_corner(corner));
    return TriangleSide{std::min(a, b), std::max(a, b), corner};
  };
  for (std::uint32_t corner = 0; corner < corner_count; ++corner) {
    ++start[make_side(corner).low + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<TriangleSide> sides(corner_count);
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t corner = 0; corner < corner_count; ++corner) {
    const TriangleSide side = make_side(corner);
    sides[next[side.low]++] = side;
  }
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    std::sort(sides.begin() + start[v], sides.begin() + start[v + 1],
              [](const TriangleSide& a, const TriangleSide& b) {
                return a.high != b.high ? a.high < b.high : a.corner < b.corner;
              });
  }
  return sides;
}

DisjointSets corners_by_fan(const TriangleMesh& mesh, const std::vector<TriangleSide>& sides) {
  DisjointSets corners(3 * mesh.triangles.size());
  for_each_edge(sides, [&](auto first, auto last) {
    const std::uint32_t start = first->corner, end = next_corner(first->corner);
    for (auto side = first + 1; side != last; ++side) {
      std::uint32_t at_start = side->corner, at_end = next_corner(side->corner);
      if (vertex_at(mesh, at_start) != vertex_at(mesh, start)) std::swap(at_start, at_end);
      corners.unite(start, at_start);
      corners.unite(end, at_end);
    }
  });
  return corners;
}

}  // namespace tegata
