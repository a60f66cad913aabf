// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_fit_target.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tegata/base/error.h"

namespace tegata {
namespace {

/// A square of side 1 in one large and many small triangles.
TriangleMesh uneven_square() {
  TriangleMesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  mesh.triangles = {{0, 1, 2}};
  constexpr std::uint32_t kParts = 40;
  for (std::uint32_t i = 0; i <= kParts; ++i) {
    const double part = i / static_cast<double>(kParts);
    mesh.vertices.push_back({1.0 - part, part, 0.0});
  }
  mesh.vertices.push_back({1.0, 1.0, 0.0});
  for (std::uint32_t i = 0; i < kParts; ++i) {
    mesh.triangles.push_back({3 + i, 3 + kParts + 1, 4 + i});
  }
  return mesh;
}

TEST(EvenlySampled, IsEvenByAreaWhateverTheTriangles) {
  const TriangleMesh mesh = uneven_square();
  const std::vector<SurfacePoint> points = evenly_sampled(mesh);
  EXPECT_NEAR(static_cast<double>(points.size()), 4000.0, 2.0);
  std::array<int, 16> counts = {};
  for (const SurfacePoint& point : points) {
    const Eigen::Vector3d place = place_on(mesh, point);
    ++counts[static_cast<std::size_t>(4 * std::floor(4.0 * place.x()) +
                                      std::floor(4.0 * place.y()))];
  }
  for (const int count : counts) EXPECT_NEAR(count, 250, 40);
}

TEST(PointOfTriangle, GivesBackThePoint) {
  const TriangleMesh mesh = uneven_square();
  const Eigen::Vector3d point(0.3, 0.25, 0.0);
  const SurfacePoint found = point_of_triangle(mesh, 0, point);
  EXPECT_LT((place_on(mesh, found) - point).norm(), 1e-12);
  EXPECT_NEAR(found.corners.sum(), 1.0, 1e-12);
}

TEST(PointOfTriangle, WithoutAreaIsACorner) {
  TriangleMesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(place_on(mesh, point_of_triangle(mesh, 0, {0.5, 0.0, 0.0})), mesh.vertices[0]);
  EXPECT_EQ(triangle_normal(mesh, 0), Eigen::Vector3d::Zero());
  EXPECT_THROW(evenly_sampled(mesh), Error);
}

}  // namespace
}  // namespace tegata
