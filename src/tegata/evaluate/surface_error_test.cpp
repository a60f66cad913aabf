// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/evaluate/surface_error.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/mesh/shapes_for_tests.h"

namespace tegata {
namespace {

using Plane = Eigen::Hyperplane<double, 3>;

const Plane kEverything(Eigen::Vector3d::UnitZ(), Eigen::Vector3d(0.0, 0.0, -100.0));

// A square of the given corner and side in the plane z = height, of cells x cells x 2 triangles.
TriangleMesh square(double corner, double side, double height, std::uint32_t cells) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      mesh.vertices.emplace_back(corner + side * i / cells, corner + side * j / cells, height);
    }
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

TEST(HeldObjectError, OnlyWhatTheHandIsNearCounts) {
  // Of a plate the hand is near one half; the found one is 2 mm off there and absent elsewhere.
  const TriangleMesh truth = square(0.0, 0.1, 0.0, 20), hand = square(0.0, 0.05, 0.005, 5);
  TriangleMesh found = square(-0.02, 0.09, -0.002, 5);
  const auto error = held_object_error(found, truth, hand, 0.0051);
  ASSERT_TRUE(error.has_value());
  EXPECT_NEAR(*error, 0.002, 1e-4);
  EXPECT_FALSE(held_object_error(found, truth, hand, 0.004).has_value());
}

TEST(SampleSurface, PointsSpreadByAreaNotByVertices) {
  TriangleMesh mesh = square(0.0, 1.0, 0.0, 1);
  shapes::append(mesh, square(10.0, 1.0, 0.0, 20));
  const auto points = sample_surface(mesh, 10000);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::size_t on_coarse = 0;
  for (const Eigen::Vector3d& point : points) {
    mean += point / 10000.0;
    if (point.x() < 5.0) ++on_coarse;
  }
  EXPECT_NEAR(static_cast<double>(on_coarse), 5000.0, 1.0);
  EXPECT_NEAR(mean.x(), 5.5, 0.02);
  EXPECT_NEAR(mean.y(), 5.5, 0.02);
  EXPECT_EQ(points, sample_surface(mesh, 10000));
}

TEST(SurfaceError, EqualSurfacesOfOtherTrianglesAreEqual) {
  EXPECT_NEAR(surface_error(square(0.0, 1.0, 0.0, 3), square(0.0, 1.0, 0.0, 8), kEverything), 0.0,
              1e-12);
}

TEST(SurfaceError, ParallelSurfacesAreTheirDistanceApart) {
  EXPECT_NEAR(surface_error(square(0.0, 1.0, 0.25, 3), square(0.0, 1.0, 0.0, 8), kEverything), 0.25,
              1e-12);
}

// The small square is part of the large one; the mean distance of the points of [0, 2]^2 from
// [0, 1]^2 is 1/4 * (2 * 1/2 + (sqrt(2) + asinh(1)) / 3).
TEST(SurfaceError, BothDirectionsCount) {
  const double there = 0.25 * (1.0 + (std::sqrt(2.0) + std::asinh(1.0)) / 3.0);
  const TriangleMesh small = square(0.0, 1.0, 0.0, 2), large = square(0.0, 2.0, 0.0, 2);
  EXPECT_NEAR(surface_error(small, large, kEverything), 0.5 * there, 0.005);
  EXPECT_NEAR(surface_error(large, small, kEverything), 0.5 * there, 0.005);
}

TEST(SurfaceError, WhatLiesBehindTheWristDoesNotCount) {
  TriangleMesh fitted = square(0.0, 1.0, 0.1, 2), truth = square(0.0, 1.0, 0.0, 2);
  // The forearm of the fitted one is long and goes elsewhere.
  shapes::append(fitted, square(-30.0, 20.0, 5.0, 4));
  const Plane plane(Eigen::Vector3d::UnitX(), Eigen::Vector3d(-0.5, 0.0, 0.0));
  EXPECT_NEAR(surface_error(fitted, truth, plane), 0.1, 1e-9);
  EXPECT_GT(surface_error(fitted, truth, kEverything), 5.0);
}

TEST(SurfaceError, AFitBehindTheWristIsFarOffAndNotAnError) {
  const Plane plane(Eigen::Vector3d::UnitX(), Eigen::Vector3d(-0.5, 0.0, 0.0));
  EXPECT_GT(surface_error(square(-3.0, 1.0, 0.0, 2), square(0.0, 1.0, 0.0, 2), plane), 2.0);
}

TEST(SurfaceError, SurfacesOfNothingAreErrors) {
  EXPECT_THROW(surface_error(TriangleMesh(), square(0.0, 1.0, 0.0, 2), kEverything), Error);
  EXPECT_THROW(surface_error(square(0.0, 1.0, 0.0, 2), TriangleMesh(), kEverything), Error);
  const Plane ahead(Eigen::Vector3d::UnitX(), Eigen::Vector3d(5.0, 0.0, 0.0));
  EXPECT_THROW(surface_error(square(0.0, 9.0, 0.0, 2), square(0.0, 1.0, 0.0, 2), ahead), Error);
}

TEST(VertexError, NeedsTheSameTriangles) {
  const TriangleMesh mesh = square(0.0, 1.0, 0.0, 2);
  TriangleMesh shifted = mesh;
  shapes::move(shifted, {0.0, 0.003, 0.004});
  EXPECT_NEAR(vertex_error(shifted, mesh).value(), 0.005, 1e-12);
  EXPECT_FALSE(vertex_error(square(0.0, 1.0, 0.0, 3), mesh).has_value());
  std::swap(shifted.triangles[0], shifted.triangles[1]);
  EXPECT_FALSE(vertex_error(shifted, mesh).has_value());
}

}  // namespace
}  // namespace tegata
