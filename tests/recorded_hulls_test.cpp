// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The hull of recorded silhouettes, next to what is known of the object.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tegata/base/text.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/image/rasterizer.h"
#include "tegata/mesh/closest_point.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/segment/components.h"
#include "tegata/take/picture_file.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

const fs::path kTemple = fs::path(TEGATA_DATA_DIR) / "temple_16view";
const fs::path kRabbit = fs::path(TEGATA_DATA_DIR) / "bunny_6view";

// Hand where any channel is above a level.
Silhouette thresholded(const CameraImage& picture, int level) {
  Silhouette silhouette(picture.values.width(), picture.values.height(), PixelLabel::background);
  for (int y = 0; y < picture.values.height(); ++y) {
    for (int x = 0; x < picture.values.width(); ++x) {
      for (int c = 0; c < picture.values.channels(); ++c) {
        if (picture.values(x, y, c) > level) silhouette(x, y) = PixelLabel::hand;
      }
    }
  }
  return silhouette;
}

// Camera poses as camera-to-world, in millimetres.
std::vector<HullView> rabbit_views() {
  std::vector<HullView> views;
  std::ifstream poses(kRabbit / "tumpose.txt");
  std::string name;
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
  while (poses >> name >> position.x() >> position.y() >> position.z() >> rotation.x() >>
         rotation.y() >> rotation.z() >> rotation.w()) {
    HullView view;
    view.silhouette = thresholded(read_picture(kRabbit / ("mask_" + name + ".png")), 127);
    view.camera.name = name;
    view.camera.width = view.silhouette.width();
    view.camera.height = view.silhouette.height();
    view.camera.fx = view.camera.fy = 258.65;
    view.camera.cx = 159.3;
    view.camera.cy = 127.65;
    view.camera.camera_from_world = Rigid3d{rotation.normalized(), position}.inverse();
    views.push_back(view);
  }
  return views;
}

std::vector<HullView> temple_views() {
  // Above the velvet that the temple stands on, below most of the marble; its shadows are holes.
  constexpr int kLevel = 65;
  constexpr int kShadowPx = 1500;
  std::vector<HullView> views;
  std::ifstream parameters(kTemple / "templeSR_par.txt");
  std::size_t count = 0;
  parameters >> count;
  for (std::size_t i = 0; i < count; ++i) {
    std::string name;
    Eigen::Matrix3d intrinsics, rotation;
    Eigen::Vector3d translation;
    parameters >> name;
    for (Eigen::Matrix3d* matrix : {&intrinsics, &rotation}) {
      for (int k = 0; k < 9; ++k) parameters >> (*matrix)(k / 3, k % 3);
    }
    parameters >> translation.x() >> translation.y() >> translation.z();
    HullView view;
    view.silhouette = thresholded(read_picture(kTemple / name), kLevel);
    keep_large_components(view.silhouette, 1.0);
    fill_pinholes(view.silhouette, kShadowPx);
    view.camera.name = name;
    view.camera.width = view.silhouette.width();
    view.camera.height = view.silhouette.height();
    view.camera.fx = intrinsics(0, 0);
    view.camera.fy = intrinsics(1, 1);
    view.camera.cx = intrinsics(0, 2);
    view.camera.cy = intrinsics(1, 2);
    view.camera.camera_from_world = {Eigen::Quaterniond(rotation).normalized(), translation};
    views.push_back(view);
  }
  return views;
}

void expect_sound_and_covering(const TriangleMesh& mesh, const std::vector<HullView>& views,
                               double least_overlap) {
  const MeshTopology topology = inspect_topology(mesh);
  EXPECT_TRUE(topology.closed && topology.oriented && topology.manifold);
  for (const HullView& view : views) {
    EXPECT_GE(intersection_over_union(render_silhouette(mesh, view.camera), view.silhouette),
              least_overlap)
        << "view " << view.camera.name;
  }
}

TEST(RecordedHulls, SixMasksOfARabbitAreCoveredAndItsSurfaceIsHeld) {
  if (!fs::exists(kRabbit)) GTEST_SKIP() << kRabbit << " is not there";
  const std::vector<HullView> views = rabbit_views();
  ASSERT_EQ(views.size(), 6u);
  HullOptions options;
  options.voxel_size = find_region(views, options).sizes().maxCoeff() / 256.0;
  const TriangleMesh rabbit = read_ply(kRabbit / "GT.ply");
  const double size = bounding_box(rabbit).sizes().maxCoeff();
  for (const std::size_t triangle_count : {std::size_t{0}, std::size_t{8000}}) {
    options.triangle_count = triangle_count;
    const TriangleMesh mesh = visual_hull(views, options);
    expect_sound_and_covering(mesh, views, 0.95);
    const NearestSurface surface(mesh);
    std::size_t held = 0;
    for (const Eigen::Vector3d& vertex : rabbit.vertices) {
      const auto match = surface.nearest(vertex);
      const auto& [a, b, c] = mesh.triangles[match.triangle];
      const Eigen::Vector3d normal =
          (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
      const bool is_inside = normal.dot(vertex - match.point) < 0.0;
      held += is_inside || match.distance < 0.02 * size ? 1 : 0;
    }
    EXPECT_GE(held, rabbit.vertices.size() * 99 / 100) << "of " << rabbit.vertices.size();
  }
}

TEST(RecordedHulls, SixteenPhotographsOfATempleFillItsBoundingBox) {
  if (!fs::exists(kTemple)) GTEST_SKIP() << kTemple << " is not there";
  const std::vector<HullView> views = temple_views();
  ASSERT_EQ(views.size(), 16u);
  HullOptions options;
  options.voxel_size = 0.001;
  options.triangle_count = 0;
  const TriangleMesh mesh = visual_hull(views, options);
  expect_sound_and_covering(mesh, views, 0.92);
  // Published with the recording, as tight.
  const Eigen::AlignedBox3d published(Eigen::Vector3d(-0.073568, 0.021728, -0.012445),
                                      Eigen::Vector3d(0.028855, 0.181892, 0.062736));
  const Eigen::AlignedBox3d found = bounding_box(mesh);
  const Eigen::Vector3d tolerance = 0.03 * published.sizes();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(found.max()[axis], published.max()[axis], tolerance[axis]) << "axis " << axis;
    if (axis != 1) {
      EXPECT_NEAR(found.sizes()[axis], published.sizes()[axis], tolerance[axis]) << "axis " << axis;
    }
  }
  // All cameras look down by eight degrees: below the base the exact hull ends in a wedge of 8 mm.
  EXPECT_NEAR(found.min().y(), published.min().y() - 0.008, tolerance.y());
}

}  // namespace
}  // namespace tegata
