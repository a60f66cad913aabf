// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/closest_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/mesh/shapes_for_tests.h"

namespace tegata {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

void expect_like_brute_force(const Points& points, const Points& queries) {
  const NearestPoint nearest(points);
  for (const Eigen::Vector3d& query : queries) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < points.size(); ++i) {
      if ((points[i] - query).squaredNorm() < (points[best] - query).squaredNorm()) best = i;
    }
    const auto match = nearest.nearest(query);
    ASSERT_EQ(match.index, best) << "query " << query.transpose();
    ASSERT_EQ(match.distance, (points[best] - query).norm());
  }
}

Points queries_around(const Points& points, Random& random) {
  Points queries;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d& point = points[random.index(points.size())];
    for (const double size : {0.0, 0.01, 0.3, 10.0}) {
      queries.push_back(point + random_vector(random, size));
    }
  }
  return queries;
}

TEST(NearestPoint, IsThatOfBruteForceOnASurface) {
  Random random(1);
  for (const double scale : {1e-3, 1.0, 1e4}) {
    Points points = shapes::torus(0.1, 0.03, 60, 30).vertices, queries;
    for (Eigen::Vector3d& point : points) point *= scale;
    queries = queries_around(points, random);
    expect_like_brute_force(points, queries);
  }
}

TEST(NearestPoint, IsThatOfBruteForceInEveryKindOfCloud) {
  Random random(2);
  Points cloud, plane, line, one_place(20, Eigen::Vector3d(1.0, 2.0, 3.0)), clusters;
  for (int i = 0; i < 500; ++i) {
    cloud.push_back(random_vector(random, 1.0));
    plane.emplace_back(random.uniform(), 2.0, random.uniform());
    line.emplace_back(1.0, random.uniform(), -1.0);
    clusters.push_back(random_vector(random, 1e-4) + Eigen::Vector3d(i % 2 * 100.0, 0.0, 0.0));
  }
  for (const Points& points : {cloud, plane, line, one_place, clusters, Points{cloud.front()}}) {
    expect_like_brute_force(points, queries_around(points, random));
  }
}

TEST(NearestPoint, TakesTheLowestIndexOfEquallyNearPoints) {
  Points lattice;
  for (int i = 0; i < 512; ++i) lattice.emplace_back(i / 64, i / 8 % 8, i % 8);
  Points reversed(lattice.rbegin(), lattice.rend());
  Points queries;
  for (int i = 0; i < 343; ++i) {
    queries.emplace_back(i / 49 + 0.5, i / 7 % 7 + 0.5, i % 7 + 0.5);
    queries.emplace_back(i / 49 + 0.5, i / 7 % 7, i % 7);
  }
  expect_like_brute_force(lattice, queries);
  expect_like_brute_force(reversed, queries);
}

TEST(NearestPoint, RefusesNoPointsAndPointsThatAreNotFinite) {
  EXPECT_THROW(NearestPoint({}), Error);
  EXPECT_THROW(NearestPoint({{0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}}), Error);
}

// The nearest of a fine net of points on the triangle.
double sampled_distance(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  constexpr int kSteps = 200;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
      best = std::min(best, (a + u * (b - a) + v * (c - a) - query).norm());
    }
  }
  return best;
}

TEST(ClosestPointOnTriangle, IsOnTheTriangleAndNoPointOfItIsNearer) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d a = random_vector(random, 1.0), b = random_vector(random, 1.0),
                          c = random_vector(random, 1.0), query = random_vector(random, 2.0);
    const Eigen::Vector3d point = closest_point_on_triangle(query, a, b, c);
    const double sampled = sampled_distance(query, a, b, c);
    EXPECT_LE((point - query).norm(), sampled + 1e-12);
    EXPECT_GE((point - query).norm(), sampled - 0.03);
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    EXPECT_NEAR((point - a).dot(normal), 0.0, 1e-9);
    const double parts = (b - a).cross(point - a).norm() + (c - b).cross(point - b).norm() +
                         (a - c).cross(point - c).norm();
    EXPECT_NEAR(parts, normal.norm(), 1e-9);  // areas add up: it is within
  }
}

TEST(ClosestPointOnTriangle, HandlesTrianglesWithoutArea) {
  const Eigen::Vector3d a(0.0, 0.0, 0.0), b(1.0, 0.0, 0.0), c(2.0, 0.0, 0.0);
  const Eigen::Vector3d query(1.5, 1.0, 0.0), foot(1.5, 0.0, 0.0);
  EXPECT_LT((closest_point_on_triangle(query, a, b, c) - foot).norm(), 1e-12);
  EXPECT_LT((closest_point_on_triangle(query, b, c, a) - foot).norm(), 1e-12);
  EXPECT_LT((closest_point_on_triangle(query, a, a, c) - foot).norm(), 1e-12);
  EXPECT_EQ(closest_point_on_triangle(query, b, b, b), b);
}

TEST(NearestSurface, IsThatOfBruteForce) {
  const TriangleMesh mesh = shapes::torus(0.1, 0.03, 40, 20);
  const NearestSurface surface(mesh);
  Random random(4);
  for (const Eigen::Vector3d& query : queries_around(mesh.vertices, random)) {
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : mesh.triangles) {
      const Eigen::Vector3d point =
          closest_point_on_triangle(query, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
      best = std::min(best, (point - query).norm());
    }
    const auto match = surface.nearest(query);
    ASSERT_NEAR(match.distance, best, 1e-15);
    ASSERT_NEAR((match.point - query).norm(), match.distance, 1e-15);
    const auto& [a, b, c] = mesh.triangles[match.triangle];
    ASSERT_EQ(match.point, closest_point_on_triangle(query, mesh.vertices[a], mesh.vertices[b],
                                                     mesh.vertices[c]));
  }
}

TEST(NearestSurface, MeasuresATorusExactlyEnough) {
  const NearestSurface surface(shapes::torus(0.1, 0.03, 300, 150));
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d query = random_vector(random, 0.2);
    const double from_tube = std::hypot(std::hypot(query.x(), query.y()) - 0.1, query.z());
    EXPECT_NEAR(surface.nearest(query).distance, std::abs(from_tube - 0.03), 1e-4);
  }
}

TEST(NearestSurface, RefusesAMeshWithoutTriangles) {
  EXPECT_THROW(NearestSurface(TriangleMesh{}), Error);
}

}  // namespace
}  // namespace tegata
