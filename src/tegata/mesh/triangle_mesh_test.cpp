// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/mesh/shapes_for_tests.h"

namespace tegata {
namespace {

using shapes::append;
using shapes::torus;
using shapes::unit_cube;

void expect_sound(const MeshTopology& topology) {
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_TRUE(topology.manifold);
}

TEST(MeshTopology, CountsHandlesAndPieces) {
  const MeshTopology cube = inspect_topology(unit_cube());
  expect_sound(cube);
  EXPECT_EQ(cube.euler_number, 2);
  EXPECT_EQ(cube.component_count, 1);

  TriangleMesh both = torus(1.0, 0.3, 12, 7);
  append(both, unit_cube());
  const MeshTopology topology = inspect_topology(both);
  expect_sound(topology);
  EXPECT_EQ(topology.euler_number, 2);  // 0 of the torus and 2 of the cube
  EXPECT_EQ(topology.component_count, 2);
}

TEST(MeshTopology, SeesAHole) {
  TriangleMesh mesh = unit_cube();
  mesh.triangles.pop_back();
  const MeshTopology topology = inspect_topology(mesh);
  EXPECT_FALSE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_TRUE(topology.manifold);
}

TEST(MeshTopology, SeesATriangleTurnedOver) {
  TriangleMesh mesh = unit_cube();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const MeshTopology topology = inspect_topology(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_FALSE(topology.oriented);
}

TEST(MeshTopology, SeesTwoPiecesThatTouchInAVertex) {
  TriangleMesh mesh = unit_cube();
  append(mesh, unit_cube());
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = v == 8 ? 7 : v;  // corner 0 of the second is corner 7
  }
  const MeshTopology topology = inspect_topology(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_FALSE(topology.manifold);
  EXPECT_EQ(topology.component_count, 2);
}

TEST(MeshTopology, SeesTwoPiecesThatTouchInAnEdge) {
  TriangleMesh mesh = unit_cube();
  append(mesh, unit_cube());
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = v == 8 ? 6 : (v == 9 ? 7 : v);
  }
  const MeshTopology topology = inspect_topology(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_FALSE(topology.manifold);
  EXPECT_EQ(topology.component_count, 1);
}

TEST(MeshTopology, SeesATriangleThatUsesAVertexTwice) {
  TriangleMesh mesh = unit_cube();
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_FALSE(inspect_topology(mesh).manifold);
}

TEST(TriangleMesh, MeasuresACubeFarFromTheOrigin) {
  TriangleMesh mesh = unit_cube();
  shapes::move(mesh, {1e6, -1e6, 1e6});
  EXPECT_NEAR(enclosed_volume(mesh), 1.0, 1e-9);
  EXPECT_NEAR(surface_area(mesh), 6.0, 1e-9);
  EXPECT_EQ(bounding_box(mesh).sizes(), Eigen::Vector3d::Ones());
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(enclosed_volume(mesh), -1.0, 1e-9);
  EXPECT_TRUE(bounding_box(TriangleMesh{}).isEmpty());
}

TEST(TriangleMesh, NormalsOfATorusPointAwayFromItsTube) {
  const TriangleMesh mesh = torus(1.0, 0.3, 60, 40);
  const auto normals = vertex_normals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Eigen::Vector3d& p = mesh.vertices[v];
    const Eigen::Vector3d center = Eigen::Vector3d(p.x(), p.y(), 0.0).normalized();
    ASSERT_GT(normals[v].dot((p - center).normalized()), 0.99);
    ASSERT_NEAR(normals[v].norm(), 1.0, 1e-12);
  }
}

TEST(TriangleMesh, NormalsThatCancelAreZeroAndNotNoise) {
  TriangleMesh mesh;
  mesh.vertices = {{0.1, 0.2, 0.3}, {1.3, 0.1, 0.7}, {0.2, 1.7, 0.9}, {5.0, 5.0, 5.0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  for (const Eigen::Vector3d& normal : vertex_normals(mesh)) {
    EXPECT_EQ(normal, Eigen::Vector3d::Zero());
  }
}

TEST(TriangleMesh, RefusesIndicesOutOfRangeAndNumbersThatAreNotFinite) {
  TriangleMesh mesh = unit_cube();
  EXPECT_NO_THROW(check_mesh(mesh));
  mesh.triangles[3][1] = 8;
  EXPECT_THROW(check_mesh(mesh), Error);
  mesh = unit_cube();
  mesh.vertices[2].y() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(check_mesh(mesh), Error);
  mesh = unit_cube();
  mesh.unproven.assign(3, 0);
  EXPECT_THROW(check_mesh(mesh), Error);
}

}  // namespace
}  // namespace tegata
