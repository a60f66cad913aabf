// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The cases are derived, not listed. On each face of the cell the surface leaves segments between
// crossed edges; the segments of the six faces join to loops; each loop is filled with triangles.
// Two cells agree on their common face because the segments there depend on its four corners alone.
// Nothing else may lie in a face: a diagonal with both ends on one face could coincide with one of
// the neighbour's and give an edge four triangles, so such diagonals are not used.
#include "tegata/hull/cube_cases.h"

#include <algorithm>
#include <cstddef>

namespace tegata {
namespace {

using Loop = std::vector<std::uint8_t>;

constexpr std::uint8_t kNotCrossed = 255;

// The corners of each face, counter-clockwise seen from outside the cell.
constexpr std::array<std::array<std::uint8_t, 4>, 6> kFaces = {{
    {0, 4, 6, 2},
    {1, 3, 7, 5},  // x = 0, x = 1
    {0, 1, 5, 4},
    {2, 6, 7, 3},  // y = 0, y = 1
    {0, 2, 3, 1},
    {4, 5, 7, 6},  // z = 0, z = 1
}};

std::uint8_t edge_between(std::uint8_t a, std::uint8_t b) {
  const auto& edges = cube_edges();
  const auto edge = std::find_if(edges.begin(), edges.end(), [&](const CubeEdge& e) {
    return e.low_corner == std::min(a, b) && e.high_corner == std::max(a, b);
  });
  return static_cast<std::uint8_t>(edge - edges.begin());
}

bool is_on_face(std::uint8_t edge, const std::array<std::uint8_t, 4>& face) {
  const auto has = [&](std::uint8_t corner) {
    return std::find(face.begin(), face.end(), corner) != face.end();
  };
  return has(cube_edges()[edge].low_corner) && has(cube_edges()[edge].high_corner);
}

bool share_a_face(std::uint8_t edge_a, std::uint8_t edge_b) {
  return std::any_of(kFaces.begin(), kFaces.end(), [&](const auto& face) {
    return is_on_face(edge_a, face) && is_on_face(edge_b, face);
  });
}

// Where the segment that begins on each crossed edge ends. Walking around a face, a segment runs
// from where the walk enters the inside to where it leaves it again; of four corners that
// alternate, each inside one is cut off by itself.
std::array<std::uint8_t, 12> segments(unsigned inside) {
  std::array<std::uint8_t, 12> end;
  end.fill(kNotCrossed);
  const auto is_inside = [&](std::uint8_t corner) { return (inside >> corner & 1u) != 0; };
  for (const auto& face : kFaces) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_inside(face[i]) || !is_inside(face[(i + 1) % 4])) continue;
      std::size_t last = i + 1;  // of this run of inside corners
      while (is_inside(face[(last + 1) % 4])) ++last;
      end[edge_between(face[i], face[(i + 1) % 4])] =
          edge_between(face[last % 4], face[(last + 1) % 4]);
    }
  }
  return end;
}

// Fills the loop's stretch from `first` to `last`, whose chord is a side or an allowed diagonal.
bool fill(const Loop& loop, std::size_t first, std::size_t last,
          std::vector<std::array<std::uint8_t, 3>>& triangles) {
  if (last - first < 2) return true;
  const auto is_allowed = [&](std::size_t a, std::size_t b) {
    return b - a == 1 || !share_a_face(loop[a], loop[b]);
  };
  for (std::size_t middle = first + 1; middle < last; ++middle) {
    if (!is_allowed(first, middle) || !is_allowed(middle, last)) continue;
    const std::size_t count = triangles.size();
    triangles.push_back({loop[first], loop[middle], loop[last]});
    if (fill(loop, first, middle, triangles) && fill(loop, middle, last, triangles)) return true;
    triangles.resize(count);
  }
  return false;
}

CubeCase make_case(unsigned inside) {
  CubeCase result;
  auto next = segments(inside);
  for (std::uint8_t edge = 0; edge < 12; ++edge) {
    if (next[edge] != kNotCrossed) result.edges.push_back(edge);
  }
  for (std::uint8_t start = 0; start < 12; ++start) {
    Loop loop;
    for (std::uint8_t edge = start; next[edge] != kNotCrossed;) {
      loop.push_back(edge);
      const std::uint8_t follower = next[edge];
      next[edge] = kNotCrossed;
      edge = follower;
    }
    if (loop.empty() || fill(loop, 0, loop.size() - 1, result.triangles)) continue;
    const auto middle = static_cast<std::uint8_t>(12 + result.centered_loops.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      result.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
    }
    result.centered_loops.push_back(loop);
  }
  return result;
}

}  // namespace

const std::array<CubeEdge, 12>& cube_edges() {
  static const std::array<CubeEdge, 12> edges = [] {
    std::array<CubeEdge, 12> made;
    std::size_t count = 0;
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      for (std::uint8_t corner = 0; corner < 8; ++corner) {
        if ((corner >> axis & 1) != 0) continue;
        made[count++] = {axis, corner, static_cast<std::uint8_t>(corner | 1 << axis)};
      }
    }
    return made;
  }();
  return edges;
}

const std::array<CubeCase, 256>& cube_cases() {
  static const std::array<CubeCase, 256> cases = [] {
    std::array<CubeCase, 256> made;
    for (unsigned inside = 0; inside < 256; ++inside) made[inside] = make_case(inside);
    return made;
  }();
  return cases;
}

}  // namespace tegata
