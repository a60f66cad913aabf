// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/manifold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/base/random.h"
#include "tegata/mesh/shapes_for_tests.h"

namespace tegata {
namespace {

void expect_sound(const TriangleMesh& mesh) {
  const MeshTopology topology = inspect_topology(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_TRUE(topology.manifold);
}

// Two cubes whose vertices listed in pairs (of the second, of the first) are the same.
TriangleMesh joined_cubes(const Eigen::Vector3d& offset,
                          const std::vector<std::pair<std::uint32_t, std::uint32_t>>& common) {
  TriangleMesh mesh = shapes::unit_cube(), other = shapes::unit_cube();
  shapes::move(other, offset);
  shapes::append(mesh, other);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) {
      for (const auto& [from, to] : common) v = v == from + 8 ? to : v;
    }
  }
  return without_unused_vertices(mesh);
}

TEST(AsManifold, LeavesAManifoldAsItIs) {
  TriangleMesh mesh = shapes::torus(1.0, 0.3, 12, 7);
  mesh.unproven.assign(mesh.vertices.size(), 1);
  const TriangleMesh same = as_manifold(mesh);
  EXPECT_EQ(same.vertices, mesh.vertices);
  EXPECT_EQ(same.triangles, mesh.triangles);
  EXPECT_EQ(same.unproven, mesh.unproven);
}

TEST(AsManifold, SeparatesPiecesThatTouchInAVertex) {
  const TriangleMesh mesh = as_manifold(joined_cubes({1.0, 1.0, 1.0}, {{0, 7}}));
  expect_sound(mesh);
  EXPECT_EQ(mesh.vertices.size(), 16u);
  EXPECT_EQ(inspect_topology(mesh).euler_number, 4);
}

TEST(AsManifold, SeparatesPiecesThatTouchInAnEdge) {
  const TriangleMesh mesh = as_manifold(joined_cubes({1.0, 1.0, 0.0}, {{0, 3}, {4, 7}}));
  expect_sound(mesh);
  EXPECT_EQ(inspect_topology(mesh).component_count, 2);
  EXPECT_EQ(inspect_topology(mesh).euler_number, 4);
  EXPECT_NEAR(enclosed_volume(mesh), 2.0, 1e-12);
  EXPECT_NEAR(surface_area(mesh), 12.0, 1e-12);
}

TEST(AsManifold, DropsTrianglesThatLieBackToBack) {
  TriangleMesh mesh = shapes::unit_cube();
  mesh.vertices.emplace_back(0.5, 0.5, 2.0);
  mesh.triangles.insert(mesh.triangles.end(), {{4, 7, 8}, {7, 4, 8}});
  EXPECT_FALSE(inspect_topology(mesh).manifold);
  const TriangleMesh plain = as_manifold(mesh);
  expect_sound(plain);
  EXPECT_EQ(plain.triangles, shapes::unit_cube().triangles);
  EXPECT_EQ(plain.vertices.size(), 8u);
}

TEST(AsManifold, KeepsTheSurfaceAndItsMarksWhereRandomVerticesAreWelded) {
  Random random(9);
  for (int round = 0; round < 300; ++round) {
    TriangleMesh mesh = shapes::torus(1.0, 0.4, 8, 5);
    shapes::append(mesh, shapes::torus(1.0, 0.3, 6, 4));
    mesh.unproven.assign(mesh.vertices.size(), 0);
    for (int weld = 0; weld < 6; ++weld) {
      const auto from = static_cast<std::uint32_t>(random.index(mesh.vertices.size()));
      const auto to = static_cast<std::uint32_t>(random.index(mesh.vertices.size()));
      for (Triangle& t : mesh.triangles) std::replace(t.begin(), t.end(), from, to);
      mesh.unproven[to] = 1;
    }
    std::erase_if(mesh.triangles,
                  [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    const TriangleMesh manifold = as_manifold(mesh);
    expect_sound(manifold);
    EXPECT_NEAR(enclosed_volume(manifold), enclosed_volume(mesh), 1e-9);
    EXPECT_LE(surface_area(manifold), surface_area(mesh) + 1e-9);
    EXPECT_EQ(manifold.unproven.size(), manifold.vertices.size());
    if (testing::Test::HasFailure()) FAIL() << "round " << round;
  }
}

}  // namespace
}  // namespace tegata
