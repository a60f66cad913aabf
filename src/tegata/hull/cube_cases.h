// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tegata {

/// How the surface passes through a cell, for each of the 256 ways in which its corners can lie
/// inside or outside. Corner i is at (i & 1, i >> 1 & 1, i >> 2). Edges are numbered 0 to 11, four
/// along x, four along y, four along z.
struct CubeCase {
  std::vector<std::uint8_t> edges;  ///< that the surface crosses
  /// Corners are edges' numbers, or 12 + i for the middle of loop i of `centered_loops`;
  /// counter-clockwise seen from outside.
  std::vector<std::array<std::uint8_t, 3>> triangles;
  /// Rings of edges around a middle vertex: those that no diagonals can fill.
  std::vector<std::vector<std::uint8_t>> centered_loops;
};

/// The corners that an edge joins; the first is the lower one.
struct CubeEdge {
  std::uint8_t axis = 0, low_corner = 0, high_corner = 0;
};

/// Index 0 to 255: bit i is set where corner i is inside.
const std::array<CubeCase, 256>& cube_cases();

const std::array<CubeEdge, 12>& cube_edges();

}  // namespace tegata
