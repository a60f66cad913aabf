// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/rasterizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "tegata/base/random.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

// One unit at depth 1 is one pixel.
Camera pixel_camera(int width, int height) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = 1.0;
  return camera;
}

Camera room_camera() {
  Camera camera;
  camera.width = 200;
  camera.height = 150;
  camera.fx = camera.fy = 300.0;
  camera.cx = 99.5;
  camera.cy = 74.5;
  camera.camera_from_world = {so3_exp({0.2, -0.4, 0.1}), {0.02, -0.01, 1.0}};
  return camera;
}

TriangleMesh square(double x0, double y0, double x1, double y1, double z) {
  return {{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}, {{0, 1, 2}, {0, 2, 3}}, {}, {}};
}

// A sheet of (n + 1)^2 vertices at random depths, cut into triangles one after the other; its
// vertices lie on whole pixels, where ties on edges happen.
TriangleMesh lattice(int n, int spacing, Random& random) {
  TriangleMesh mesh;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const double z = random.uniform(1.0, 3.0);
      mesh.vertices.emplace_back(x * spacing * z, y * spacing * z, z);
    }
  }
  const auto index = [&](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const std::uint32_t a = index(x, y), b = index(x + 1, y), c = index(x + 1, y + 1),
                          d = index(x, y + 1);
      if (random.uniform() < 0.5) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, d, c});  // the other way round: orientation must not matter
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  }
  return mesh;
}

TEST(Rasterizer, SharedEdgesLeaveNoGapsAndAreDrawnOnce) {
  Random random(3);
  const TriangleMesh mesh = lattice(8, 5, random);
  const Camera camera = pixel_camera(50, 50);
  Image<int> times_drawn(50, 50);
  for (const Triangle& triangle : mesh.triangles) {
    TriangleMesh one{mesh.vertices, {triangle}, {}, {}};
    const Silhouette covered = render_silhouette(one, camera);
    for (std::size_t i = 0; i < covered.values().size(); ++i) {
      if (covered.values()[i] == PixelLabel::hand) ++times_drawn.values()[i];
    }
  }
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) {
      // Top and left sides belong to the sheet, bottom and right ones do not.
      ASSERT_EQ(times_drawn(x, y), x < 40 && y < 40 ? 1 : 0) << x << ' ' << y;
    }
  }
}

TEST(Rasterizer, CoversAPixelWhereItsCentreIs) {
  const Camera camera = pixel_camera(20, 20);
  const Silhouette silhouette = render_silhouette(square(2.6, 3.4, 7.5, 8.9, 1.0), camera);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      const bool covered = x >= 3 && x <= 7 && y >= 4 && y <= 8;
      EXPECT_EQ(silhouette(x, y) == PixelLabel::hand, covered) << x << ' ' << y;
    }
  }
}

TEST(Rasterizer, DepthIsThatOfTheRayWithThePlane) {
  const Camera camera = room_camera();
  // A tilted square: linear depth in the picture would be off by centimetres.
  TriangleMesh mesh = square(-0.2, -0.2, 0.2, 0.2, 0.0);
  for (Eigen::Vector3d& p : mesh.vertices) p = so3_exp({1.1, 0.3, 0.0}) * p;
  const Eigen::Vector3d normal = so3_exp({1.1, 0.3, 0.0}) * Eigen::Vector3d::UnitZ();
  const RenderedMesh picture = render(mesh, camera);
  int covered = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      ASSERT_EQ(picture.depth(x, y) == kNothing, picture.triangle(x, y) == -1);
      if (picture.triangle(x, y) < 0) continue;
      ++covered;
      const Eigen::Vector3d direction = pixel_direction(camera, {x, y});
      const Eigen::Vector3d center = camera.center_in_world();
      const Eigen::Vector3d hit = center - normal.dot(center) / normal.dot(direction) * direction;
      ASSERT_NEAR(picture.depth(x, y), (camera.camera_from_world * hit).z(), 2e-4) << x << ' ' << y;
    }
  }
  EXPECT_GT(covered, 2000);
}

TEST(Rasterizer, TheNearerSurfaceHidesTheFartherInEitherOrder) {
  const Camera camera = pixel_camera(20, 20);
  TriangleMesh mesh = square(0.0, 0.0, 20.0, 20.0, 2.0);
  const TriangleMesh near = square(3.0, 3.0, 6.0, 6.0, 1.0);
  for (const bool near_first : {false, true}) {
    TriangleMesh both = near_first ? near : mesh;
    const TriangleMesh& other = near_first ? mesh : near;
    for (const Triangle& t : other.triangles)
      both.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
    const RenderedMesh picture = render(both, camera);
    EXPECT_FLOAT_EQ(picture.depth(4, 4), 1.0F);
    EXPECT_FLOAT_EQ(picture.depth(7, 7), 2.0F);
    EXPECT_EQ(picture.triangle(4, 4) < 2, near_first);
    EXPECT_EQ(picture.triangle(7, 7) < 2, !near_first);
  }
}

TEST(Rasterizer, TheLensBendsWhatItDraws) {
  Camera camera = room_camera();
  camera.distortion = {-0.6, 0.2, 0.002, -0.003, 0.0};
  Random random(5);
  TriangleMesh mesh = lattice(10, 1, random);
  for (Eigen::Vector3d& p : mesh.vertices)
    p = {0.06 * p.x() / p.z() - 0.3, 0.04 * p.y() / p.z() - 0.2, 0.0};
  const RenderedMesh picture = render(mesh, camera);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Eigen::Vector3d middle =
        (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    const auto pixel = project(camera, middle);
    if (!pixel || !camera.contains(*pixel)) continue;
    const int x = static_cast<int>(std::lround(pixel->x())),
              y = static_cast<int>(std::lround(pixel->y()));
    EXPECT_EQ(picture.triangle(x, y), static_cast<std::int32_t>(i)) << x << ' ' << y;
  }
}

TEST(Rasterizer, PointsThatTheLensPolynomialFoldsBackAreNotDrawn) {
  Camera camera = room_camera();
  camera.camera_from_world = {};
  camera.distortion = {0.0, 0.0, 0.0, 0.0, -6.0};
  // 2.5 off the axis at depth 1; r - 6 r^7 at 0.73 is 0.07, in the middle of the picture.
  const Silhouette silhouette = render_silhouette(square(0.72, -0.01, 0.74, 0.01, 1.0), camera);
  EXPECT_EQ(count_pixels(silhouette, PixelLabel::hand), 0U);
}

TEST(Rasterizer, LeavesOutTrianglesThatReachBehindTheCamera) {
  const Camera camera = pixel_camera(20, 20);
  TriangleMesh mesh = square(2.0, 2.0, 15.0, 15.0, 1.0);
  mesh.vertices[3].z() = -1.0;
  const RenderedMesh picture = render(mesh, camera);
  EXPECT_EQ(picture.triangle(10, 5), 0);
  EXPECT_EQ(picture.triangle(5, 10), -1);
}

TEST(Rasterizer, TheSilhouetteIsWhereThereIsDepth) {
  Random random(11);
  const TriangleMesh mesh = lattice(6, 9, random);
  Camera camera = pixel_camera(60, 60);
  camera.cx = -3.3;
  const RenderedMesh picture = render(mesh, camera);
  const Silhouette silhouette = render_silhouette(mesh, camera);
  for (std::size_t i = 0; i < silhouette.values().size(); ++i) {
    EXPECT_EQ(silhouette.values()[i] == PixelLabel::hand, picture.depth.values()[i] != kNothing);
  }
}

TEST(Rasterizer, FrontFacesOfAClosedSurfaceCoverWhatAllFacesDo) {
  TriangleMesh octahedron;
  octahedron.vertices = {{0.1, 0, 0},  {-0.1, 0, 0}, {0, 0.1, 0},
                         {0, -0.1, 0}, {0, 0, 0.1},  {0, 0, -0.1}};
  octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                          {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const Camera camera = room_camera();
  const Silhouette all = render_silhouette(octahedron, camera);
  const Silhouette front = render_silhouette(octahedron, camera, Faces::front);
  EXPECT_EQ(front, all);
  EXPECT_EQ(all(99, 74), PixelLabel::hand);
  // The nearest and the farthest of them alone.
  const std::vector<Triangle> all_triangles = octahedron.triangles;
  std::size_t drawn = 0;
  const Silhouette nothing(camera.width, camera.height, PixelLabel::background);
  for (const Triangle& triangle : all_triangles) {
    octahedron.triangles = {triangle};
    const Silhouette one = render_silhouette(octahedron, camera, Faces::front);
    drawn += one == nothing ? 0 : 1;
  }
  EXPECT_EQ(drawn, 4u);
}

// Triangles of all kinds: closed and with holes, over each other, turned inside out, in part behind
// the camera and beyond the picture, corners on pixels' centres.
TEST(Rasterizer, EdgesCoverThePixelsThatTrianglesDo) {
  Random random(5);
  std::size_t covered = 0;
  for (int trial = 0; trial < 60; ++trial) {
    TriangleMesh mesh = lattice(6, trial % 3 == 0 ? 9 : 14, random);
    for (Eigen::Vector3d& vertex : mesh.vertices) {
      if (trial % 2 == 1) vertex += 12.0 * Eigen::Vector3d(random.normal(), random.normal(), 0.0);
      if (random.uniform() < 0.03) vertex.z() = -1.0;
    }
    if (trial % 4 == 1) {
      std::erase_if(mesh.triangles, [&](const Triangle&) { return random.uniform() < 0.2; });
    }
    if (trial % 4 == 2) mesh.triangles.push_back(mesh.triangles.front());
    const Camera camera = pixel_camera(60, 50);
    const EdgedTriangles edged(mesh.triangles);
    for (const Faces faces : {Faces::all, Faces::front}) {
      const Silhouette expected = render_silhouette(mesh, camera, faces);
      ASSERT_EQ(render_silhouette(mesh.vertices, edged, camera, faces), expected) << trial;
      covered += count_pixels(expected, PixelLabel::hand);
    }
  }
  EXPECT_GT(covered, 60u * 1000u);
}

}  // namespace
}  // namespace tegata
