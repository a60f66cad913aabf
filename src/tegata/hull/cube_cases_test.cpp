// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/cube_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <utility>

namespace tegata {
namespace {

bool is_crossed(unsigned inside, std::size_t edge) {
  const CubeEdge& e = cube_edges()[edge];
  return (inside >> e.low_corner & 1u) != (inside >> e.high_corner & 1u);
}

// Whether both edges have both ends on one face of the cube.
bool share_a_face(std::uint8_t a, std::uint8_t b) {
  const unsigned corners = 1u << cube_edges()[a].low_corner | 1u << cube_edges()[a].high_corner |
                           1u << cube_edges()[b].low_corner | 1u << cube_edges()[b].high_corner;
  for (const unsigned face : {0b01010101u, 0b00110011u, 0b00001111u}) {
    if ((corners & ~face) == 0 || (corners & face) == 0) return true;
  }
  return false;
}

TEST(CubeCases, UseExactlyTheCrossedEdges) {
  for (unsigned inside = 0; inside < 256; ++inside) {
    std::set<std::uint8_t> used;
    for (const auto& t : cube_cases()[inside].triangles) used.insert(t.begin(), t.end());
    for (std::uint8_t edge = 0; edge < 12; ++edge) {
      EXPECT_EQ(used.contains(edge), is_crossed(inside, edge)) << "case " << inside;
    }
  }
}

TEST(CubeCases, OnlyTheSegmentsOfTheFacesAreBordersAndNothingElseLiesInAFace) {
  for (unsigned inside = 0; inside < 256; ++inside) {
    std::map<std::pair<std::uint8_t, std::uint8_t>, int> sides;
    for (const auto& t : cube_cases()[inside].triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [side, count] : sides) {
      EXPECT_EQ(count, 1) << "case " << inside;
      const auto [a, b] = side;
      const bool in_a_face = a < 12 && b < 12 && share_a_face(a, b);
      EXPECT_EQ(sides.contains({b, a}), !in_a_face) << "case " << inside;
    }
  }
}

TEST(CubeCases, LookOutwards) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto& triangles = cube_cases()[1u << corner].triangles;
    ASSERT_EQ(triangles.size(), 1u);
    std::array<std::array<double, 3>, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const CubeEdge& edge = cube_edges()[triangles[0][i]];
      for (unsigned axis = 0; axis < 3; ++axis) {
        p[i][axis] = 0.5 * ((edge.low_corner >> axis & 1) + (edge.high_corner >> axis & 1));
        p[i][axis] -= corner >> axis & 1u;
      }
    }
    // Seen from the corner, the determinant of the three points has the sign of the side it shows.
    const double determinant = p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
                               p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
                               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    EXPECT_GT(determinant, 0.0) << "corner " << corner;
  }
}

TEST(CubeCases, KeepInsideCornersApartOnAmbiguousFaces) {
  EXPECT_EQ(cube_cases()[0b00001001].triangles.size(), 2u);  // across a face
  EXPECT_EQ(cube_cases()[0b10000001].triangles.size(), 2u);  // across the cell
  EXPECT_EQ(cube_cases()[0b01101001].triangles.size(), 4u);  // every other corner
  EXPECT_TRUE(cube_cases()[0].triangles.empty());
  EXPECT_TRUE(cube_cases()[255].triangles.empty());
}

}  // namespace
}  // namespace tegata
