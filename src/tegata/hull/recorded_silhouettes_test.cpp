// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "tegata/hull/visual_hull.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

const std::filesystem::path kBunny = std::filesystem::path(TEGATA_DATA_DIR) / "bunny_6view";

// Six views of a rabbit, in millimetres; the README beside the recordings has the numbers.
std::vector<HullView> bunny_views() {
  std::vector<HullView> views;
  std::ifstream poses(kBunny / "tumpose.txt");
  std::string name;
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
  while (poses >> name >> position.x() >> position.y() >> position.z() >> rotation.x() >>
         rotation.y() >> rotation.z() >> rotation.w()) {
    const cv::Mat mask =
        cv::imread((kBunny / ("mask_" + name + ".png")).string(), cv::IMREAD_GRAYSCALE);
    HullView view;
    view.camera.name = name;
    view.camera.width = mask.cols;
    view.camera.height = mask.rows;
    view.camera.fx = view.camera.fy = 258.65;
    view.camera.cx = 159.3;
    view.camera.cy = 127.65;
    view.camera.camera_from_world = Rigid3d{rotation.normalized(), position}.inverse();
    view.silhouette = Silhouette(mask.cols, mask.rows, PixelLabel::background);
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        if (mask.at<unsigned char>(y, x) > 127) view.silhouette(x, y) = PixelLabel::hand;
      }
    }
    views.push_back(view);
  }
  return views;
}

TEST(RecordedSilhouettes, ARabbitsHullCoversItsSilhouettesInEveryView) {
  if (!std::filesystem::exists(kBunny)) GTEST_SKIP() << kBunny << " is absent";
  const std::vector<HullView> views = bunny_views();
  ASSERT_EQ(views.size(), 6u);
  HullOptions options;
  const double size = find_region(views, options).sizes().maxCoeff();
  options.voxel_size = size / 256.0;
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
    if (triangle_count == 0) {
      EXPECT_TRUE(topology.manifold);
    }
  }
}

}  // namespace
}  // namespace tegata
