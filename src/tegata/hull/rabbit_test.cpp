// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tegata/hull/visual_hull.h"
#include "tegata/image/rasterizer.h"
#include "tegata/mesh/closest_point.h"
#include "tegata/mesh/mesh_file.h"

namespace tegata {
namespace {

const std::filesystem::path kRabbit = std::filesystem::path(TEGATA_DATA_DIR) / "bunny_6view";

// A rabbit of known shape, in millimetres, as its six recorded cameras see it; the README beside
// the recordings has the numbers.
std::vector<HullView> views_of(const TriangleMesh& rabbit) {
  std::vector<HullView> views;
  std::ifstream poses(kRabbit / "tumpose.txt");
  std::string name;
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
  while (poses >> name >> position.x() >> position.y() >> position.z() >> rotation.x() >>
         rotation.y() >> rotation.z() >> rotation.w()) {
    Camera camera;
    camera.name = name;
    camera.width = 320;
    camera.height = 240;
    camera.fx = camera.fy = 258.65;
    camera.cx = 159.3;
    camera.cy = 127.65;
    camera.camera_from_world = Rigid3d{rotation.normalized(), position}.inverse();
    views.push_back({camera, render_silhouette(rabbit, camera)});
  }
  return views;
}

TEST(Rabbit, ItsHullHoldsItAndCoversItsSilhouettes) {
  if (!std::filesystem::exists(kRabbit)) GTEST_SKIP() << kRabbit << " is absent";
  const TriangleMesh rabbit = read_ply(kRabbit / "GT.ply");
  const std::vector<HullView> views = views_of(rabbit);
  ASSERT_EQ(views.size(), 6u);
  HullOptions options;
  options.voxel_size = find_region(views, options).sizes().maxCoeff() / 256.0;
  const double pixel = 750.0 / 258.65;
  for (const std::size_t triangle_count : {std::size_t{0}, std::size_t{8000}}) {
    options.triangle_count = triangle_count;
    const TriangleMesh mesh = visual_hull(views, options);
    for (const HullView& view : views) {
      EXPECT_GE(intersection_over_union(render_silhouette(mesh, view.camera), view.silhouette),
                0.95)
          << "view " << view.camera.name << ", " << mesh.triangles.size() << " triangles";
    }
    const MeshTopology topology = inspect_topology(mesh);
    EXPECT_TRUE(topology.closed);
    EXPECT_TRUE(topology.oriented);
    EXPECT_TRUE(topology.manifold);

    // Where a vertex of the rabbit lies outside the hull, the hull is no farther than a pixel;
    // simplification may add to that in a few places.
    const NearestSurface surface(mesh);
    std::size_t far = 0, asked = 0;
    for (std::size_t v = 0; v < rabbit.vertices.size(); v += 7, ++asked) {
      const auto match = surface.nearest(rabbit.vertices[v]);
      const auto& [a, b, c] = mesh.triangles[match.triangle];
      const Eigen::Vector3d normal = (mesh.vertices[b] - mesh.vertices[a])
                                         .cross(mesh.vertices[c] - mesh.vertices[a])
                                         .normalized();
      far += normal.dot(rabbit.vertices[v] - match.point) > 1.5 * pixel ? 1 : 0;
    }
    EXPECT_LE(far, triangle_count == 0 ? 0 : asked / 100) << "of " << asked << " vertices";
  }
}

}  // namespace
}  // namespace tegata
