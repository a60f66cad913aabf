// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"
#include "tegata/mesh/closest_point.h"
#include "tegata/mesh/shapes_for_tests.h"

namespace tegata {
namespace {

TEST(Simplify, KeepsTheShapeAndStaysClosed) {
  const TriangleMesh fine = shapes::torus(0.10, 0.03, 150, 60);
  const TriangleMesh coarse = simplify(fine, 2000);
  EXPECT_LE(coarse.triangles.size(), 2100u);
  EXPECT_GE(coarse.triangles.size(), 1900u);
  EXPECT_NEAR(enclosed_volume(coarse) / enclosed_volume(fine), 1.0, 0.01);
  const MeshTopology topology = inspect_topology(coarse);
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_TRUE(topology.manifold);
  EXPECT_EQ(topology.euler_number, 0);
}

TEST(Simplify, KeepsTheNormalsOfTheFineSurface) {
  TriangleMesh mesh = shapes::torus(0.10, 0.03, 100, 40);
  mesh.normals = vertex_normals(mesh);
  const TriangleMesh coarse = simplify(mesh, 500);
  ASSERT_EQ(coarse.normals.size(), coarse.vertices.size());
  for (std::size_t v = 0; v < coarse.vertices.size(); ++v) {
    const auto same = std::find(mesh.vertices.begin(), mesh.vertices.end(), coarse.vertices[v]);
    ASSERT_NE(same, mesh.vertices.end());
    EXPECT_EQ(coarse.normals[v],
              mesh.normals[static_cast<std::size_t>(same - mesh.vertices.begin())]);
  }
}

TEST(Simplify, StopsAtTheLargestError) {
  const TriangleMesh mesh = shapes::torus(0.10, 0.03, 200, 80);
  const NearestSurface fine(mesh);
  std::size_t last_count = mesh.triangles.size();
  for (const double largest_error : {1e-5, 1e-4, 1e-3}) {
    const TriangleMesh coarse = simplify(mesh, 0, largest_error);
    EXPECT_LT(coarse.triangles.size(), last_count) << largest_error;
    last_count = coarse.triangles.size();
    EXPECT_TRUE(inspect_topology(coarse).manifold);
    const NearestSurface surface(coarse);
    double squares = 0.0;
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      squares += (surface.nearest(vertex).point - vertex).squaredNorm();
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(mesh.vertices.size())), largest_error);
  }
  EXPECT_GT(last_count, 100u);
  EXPECT_THROW(simplify(mesh, 0, -1.0), Error);
}

TEST(Simplify, LeavesNoEdgeToFourTrianglesWhereThinPartsCollapse) {
  // Thin rings that go through each other's middle leave few triangles to each.
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    TriangleMesh ring = shapes::torus(0.1, 0.002 + 0.001 * i, 100, 12);
    shapes::move(ring, {0.08 * i, 0.0, 0.0});
    shapes::append(mesh, ring);
  }
  for (const std::size_t triangle_count : {3000u, 600u, 200u, 60u}) {
    const MeshTopology topology = inspect_topology(simplify(mesh, triangle_count));
    EXPECT_TRUE(topology.closed) << triangle_count;
    EXPECT_TRUE(topology.oriented) << triangle_count;
    EXPECT_TRUE(topology.manifold) << triangle_count;
  }
}

TEST(Simplify, LosesNothingFarFromTheOrigin) {
  TriangleMesh mesh = shapes::torus(0.10, 0.03, 100, 40);
  const TriangleMesh near = simplify(mesh, 1000);
  const Eigen::Vector3d far_away(4096.0, -8192.0, 2048.0);
  shapes::move(mesh, far_away);
  TriangleMesh far = simplify(mesh, 1000);
  shapes::move(far, -far_away);
  EXPECT_NEAR(static_cast<double>(far.triangles.size()), static_cast<double>(near.triangles.size()),
              10.0);
  EXPECT_NEAR(enclosed_volume(far) / enclosed_volume(near), 1.0, 1e-3);
}

TEST(Simplify, CarriesMarksWithTheirVertices) {
  TriangleMesh mesh = shapes::torus(0.10, 0.03, 100, 40);
  for (const Eigen::Vector3d& v : mesh.vertices) mesh.unproven.push_back(v.x() > 0.0 ? 1 : 0);
  const TriangleMesh coarse = simplify(mesh, 500);
  ASSERT_EQ(coarse.unproven.size(), coarse.vertices.size());
  for (std::size_t v = 0; v < coarse.vertices.size(); ++v) {
    EXPECT_EQ(coarse.unproven[v], coarse.vertices[v].x() > 0.0 ? 1 : 0);
  }
}

TEST(Simplify, LeavesAMeshThatIsSmallEnoughAsItIs) {
  const TriangleMesh cube = shapes::unit_cube();
  const TriangleMesh same = simplify(cube, 12);
  EXPECT_EQ(same.triangles, cube.triangles);
  EXPECT_EQ(same.vertices, cube.vertices);
  EXPECT_TRUE(simplify(TriangleMesh{}, 0).triangles.empty());
}

}  // namespace
}  // namespace tegata
