// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Hulls of solids for which it can be said of every point whether all views see it before the
// object: of a ball by the cone around it, of a box by the outline of its corners.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tegata/hull/ball_views_for_tests.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/image/rasterizer.h"
#include "tegata/mesh/closest_point.h"

namespace tegata {
namespace {

using scenes::ball_silhouette;
using scenes::views_of_ball;

const Eigen::Vector3d kKnownCenter(0.21, -0.13, 0.78);
constexpr double kBallRadius = 0.05;
const Eigen::Vector3d kHalfBox(0.045, 0.03, 0.02);

using IsInside = std::function<bool(const HullView& view, const Eigen::Vector3d& point)>;

bool is_before_ball(const HullView& view, const Eigen::Vector3d& point) {
  const Eigen::Vector3d eye = view.camera.center_in_world();
  return (point - eye).normalized().cross(kKnownCenter - eye).norm() < kBallRadius;
}

TriangleMesh box_mesh() {
  TriangleMesh box;
  for (int i = 0; i < 8; ++i) {
    box.vertices.push_back(kKnownCenter +
                           kHalfBox.cwiseProduct(Eigen::Vector3d(
                               (i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1)));
  }
  box.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return box;
}

// Whether the ray from the camera through a point meets the box (Kay and Kajiya 1986).
bool is_before_box(const HullView& view, const Eigen::Vector3d& point) {
  const Eigen::Vector3d eye = view.camera.center_in_world() - kKnownCenter;
  const Eigen::Vector3d direction = point - view.camera.center_in_world();
  double enter = 0.0, leave = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (-kHalfBox[axis] - eye[axis]) / direction[axis];
    const double b = (kHalfBox[axis] - eye[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave;
}

// The volume of the points that every view sees before the object, by a fine lattice.
double exact_volume(const std::vector<HullView>& views, const IsInside& is_before) {
  constexpr double kStep = 0.0012, kReach = 0.084;
  std::size_t count = 0;
  for (double z = -kReach; z < kReach; z += kStep) {
    for (double y = -kReach; y < kReach; y += kStep) {
      for (double x = -kReach; x < kReach; x += kStep) {
        const Eigen::Vector3d point = kKnownCenter + Eigen::Vector3d(x, y, z);
        count += std::all_of(views.begin(), views.end(),
                             [&](const HullView& view) { return is_before(view, point); });
      }
    }
  }
  return kStep * kStep * kStep * static_cast<double>(count);
}

// With smaller voxels the hull's volume comes to that of the exact hull, and its surface lies on
// that hull's: no vertex is farther from the place where membership changes than a pixel and a bit.
void expect_exact_hull(const std::vector<HullView>& views, const IsInside& is_before,
                       double pixel) {
  const double exact = exact_volume(views, is_before);
  double coarse_error = 0.0;
  for (const double voxel_size : {0.008, 0.002, 0.001}) {
    HullOptions options{.voxel_size = voxel_size, .triangle_count = 0};
    HullReport report;
    const TriangleMesh mesh = visual_hull(views, options, &report);
    const double error = std::abs(report.volume / exact - 1.0);
    if (voxel_size > 0.005) {
      coarse_error = error;
      continue;
    }
    EXPECT_LT(error, std::max(0.01, 0.5 * coarse_error)) << voxel_size << " m, " << views.size();
    if (voxel_size > 0.001) continue;
    EXPECT_LT(error, 0.01) << views.size() << " views";
    std::size_t off = 0;
    const auto is_in_hull = [&](const Eigen::Vector3d& point) {
      return std::all_of(views.begin(), views.end(),
                         [&](const HullView& view) { return is_before(view, point); });
    };
    for (std::size_t v = 0; v < mesh.vertices.size(); v += 5) {
      const Eigen::Vector3d reach = (pixel + 0.5 * voxel_size) * mesh.normals[v];
      // On both sides of the surface but for edges, which voxels round off.
      off += is_in_hull(mesh.vertices[v] + reach) || !is_in_hull(mesh.vertices[v] - reach) ? 1 : 0;
    }
    EXPECT_LT(off, mesh.vertices.size() / 5 / 20) << views.size() << " views";
  }
}

void expect_holds(const std::vector<HullView>& views, const std::vector<Eigen::Vector3d>& points,
                  double slack) {
  const TriangleMesh mesh = visual_hull(views, {.voxel_size = 0.001, .triangle_count = 0});
  const NearestSurface surface(mesh);
  for (const Eigen::Vector3d& point : points) {
    const auto match = surface.nearest(point);
    const auto& [a, b, c] = mesh.triangles[match.triangle];
    const Eigen::Vector3d normal = (mesh.vertices[b] - mesh.vertices[a])
                                       .cross(mesh.vertices[c] - mesh.vertices[a])
                                       .normalized();
    EXPECT_LT(normal.dot(point - match.point), slack) << views.size() << " views";
  }
}

TEST(KnownHulls, ABallFromThreeEightAndSixteenSides) {
  for (const int count : {3, 8, 16}) {
    const double radius_px = 55.0, pixel = kBallRadius / radius_px;
    const auto views = views_of_ball(count, kKnownCenter, kBallRadius, 0.7, radius_px);
    expect_exact_hull(views, is_before_ball, pixel);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 400; ++i) {
      const double z = -1.0 + 2.0 * (i + 0.5) / 400.0, around = 2.4 * i;
      const double ring = std::sqrt(1.0 - z * z);
      points.push_back(kKnownCenter + kBallRadius * Eigen::Vector3d(ring * std::cos(around),
                                                                    ring * std::sin(around), z));
    }
    expect_holds(views, points, pixel);
  }
}

TEST(KnownHulls, ABoxFromThreeEightAndSixteenSides) {
  for (const int count : {3, 8, 16}) {
    const double radius_px = 55.0, pixel = kBallRadius / radius_px;
    auto views = views_of_ball(count, kKnownCenter, kBallRadius, 0.7, radius_px);
    for (HullView& view : views) view.silhouette = render_silhouette(box_mesh(), view.camera);
    expect_exact_hull(views, is_before_box, pixel);
    expect_holds(views, box_mesh().vertices, 2.0 * pixel);
  }
}

TEST(KnownHulls, ABoxSeenFromFarAlongItsAxesIsItsOwnHull) {
  auto views = views_of_ball(3, kKnownCenter, kBallRadius, 20.0, 85.0);
  for (HullView& view : views) view.silhouette = render_silhouette(box_mesh(), view.camera);
  HullReport report;
  visual_hull(views, {.voxel_size = 0.001, .triangle_count = 0}, &report);
  EXPECT_NEAR(report.volume / (8.0 * kHalfBox.prod()), 1.0, 0.01);
}

}  // namespace
}  // namespace tegata
