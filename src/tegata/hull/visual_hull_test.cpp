// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/visual_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/hull/ball_views_for_tests.h"
#include "tegata/hull/marching_cubes.h"
#include "tegata/image/distance_transform.h"
#include "tegata/image/rasterizer.h"
#include "tegata/mesh/closest_point.h"

namespace tegata {
namespace {

using scenes::ball_silhouette;
using scenes::camera_at;
using scenes::views_of_ball;

constexpr double kRadius = 0.05;
const Eigen::Vector3d kCenter(0.11, -0.07, 0.93);

std::string error_of(const std::vector<HullView>& views, const HullOptions& options = {}) {
  try {
    visual_hull(views, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

HullOptions with_voxels(double voxel_size, std::size_t triangle_count = 0) {
  return {.voxel_size = voxel_size, .triangle_count = triangle_count};
}

void expect_sound(const TriangleMesh& mesh) {
  const MeshTopology topology = inspect_topology(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_TRUE(topology.manifold);
}

// The field at a point by the definition alone: every view, whole pictures, sorted values. Wants
// least_views to be given.
float plain_field(const std::vector<HullView>& views, const std::vector<Image<float>>& distances,
                  const Eigen::Vector3d& point, const HullOptions& options) {
  std::vector<double> values;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto pixel = project(views[i].camera, point);
    if (!pixel || !views[i].camera.contains(*pixel)) continue;
    const double depth = (views[i].camera.camera_from_world * point).z();
    values.push_back(static_cast<double>(sample_bilinear(distances[i], pixel->x(), pixel->y())) *
                     depth / views[i].camera.fx);
  }
  if (values.size() < static_cast<std::size_t>(options.least_views)) return -1.0f;
  std::sort(values.begin(), values.end());
  return static_cast<float>(values[static_cast<std::size_t>(options.dissenting_views)]);
}

// Off the scene's symmetries: there the field is zero, and rounding alone makes its sign.
const Eigen::Vector3d kAside = kCenter + Eigen::Vector3d(1.234e-3, -0.777e-3, 0.419e-3);

// Compares the octree's leaves with all cells of the dense lattice that the octree stands for.
void expect_like_dense_lattice(const std::vector<HullView>& views, const HullOptions& options,
                               const Eigen::AlignedBox3d& region) {
  const SparseField field = carve(views, region, options);
  std::vector<Image<float>> distances;
  for (const HullView& view : views) {
    distances.push_back(signed_distance(
        view.silhouette, [](PixelLabel label) { return label != PixelLabel::background; }));
  }
  const std::int32_t cells = 1 << (field.levels.size() - 1), corners = cells + 1;
  std::vector<bool> inside(static_cast<std::size_t>(corners * corners * corners), false);
  const auto at = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    return static_cast<std::size_t>((z * corners + y) * corners + x);
  };
  for (std::int32_t z = 1; z < cells; ++z) {
    for (std::int32_t y = 1; y < cells; ++y) {
      for (std::int32_t x = 1; x < cells; ++x) {
        const Eigen::Vector3d point = field.origin + field.cell_size * Eigen::Vector3d(x, y, z);
        inside[at(x, y, z)] = plain_field(views, distances, point, options) > 0.0f;
      }
    }
  }
  std::size_t crossed = 0;
  for (std::int32_t z = 0; z < cells; ++z) {
    for (std::int32_t y = 0; y < cells; ++y) {
      for (std::int32_t x = 0; x < cells; ++x) {
        int count = 0;
        for (int i = 0; i < 8; ++i) {
          count += inside[at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2))] ? 1 : 0;
        }
        crossed += count > 0 && count < 8 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(field.leaves.size(), crossed);
  EXPECT_GT(crossed, 100u);
  for (const OctreeLeaf& leaf : field.leaves) {
    for (int i = 0; i < 8; ++i) {
      const bool expected = inside[at(leaf.index[0] + (i & 1), leaf.index[1] + (i >> 1 & 1),
                                      leaf.index[2] + (i >> 2))];
      ASSERT_EQ(leaf.field[static_cast<std::size_t>(i)] > 0.0f, expected);
    }
  }
}

Eigen::AlignedBox3d box_around(const Eigen::Vector3d& center, double reach) {
  const Eigen::Vector3d extent = Eigen::Vector3d::Constant(reach);
  return {center - extent, center + extent};
}

TEST(Carve, KeepsWhatADenseLatticeKeeps) {
  auto views = views_of_ball(5, kCenter, kRadius, 0.6, 60.0);
  for (const int least_views : {1, 2, 4}) {
    for (int dissenting = 0; dissenting < std::min(least_views, 3); ++dissenting) {
      HullOptions options = with_voxels(0.0065);
      options.least_views = least_views;
      options.dissenting_views = dissenting;
      expect_like_dense_lattice(views, options, box_around(kAside, 0.09));
    }
  }
}

TEST(Carve, KeepsWhatADenseLatticeKeepsWithRaggedMasksAndTightFrames) {
  // The ball fills more than the frames' height, and every mask has its own holes and unknowns.
  auto views = views_of_ball(5, kCenter, kRadius, 0.3, 130.0);
  Random random(3);
  for (HullView& view : views) {
    for (int spot = 0; spot < 25; ++spot) {
      const int x0 = static_cast<int>(random.index(300)), y0 = static_cast<int>(random.index(220));
      const auto label = random.index(2) == 0 ? PixelLabel::background : PixelLabel::unknown;
      for (int y = y0; y < y0 + 12; ++y) {
        for (int x = x0; x < x0 + 12; ++x) view.silhouette(x, y) = label;
      }
    }
  }
  for (const int dissenting : {0, 1}) {
    HullOptions options = with_voxels(0.004);
    options.dissenting_views = dissenting;
    options.least_views = 2;
    expect_like_dense_lattice(views, options, box_around(kAside, 0.1));
  }
}

TEST(Carve, WorksAroundACameraThatStandsInTheRegion) {
  auto views = views_of_ball(3, kCenter, kRadius, 0.6, 60.0);
  const Camera inside = camera_at("inside", kCenter + Eigen::Vector3d(0.0, 0.06, 0.01),
                                  kCenter + Eigen::Vector3d(0.0, 0.0, 0.01), 100.0);
  views.push_back({inside, ball_silhouette(inside, kCenter, kRadius)});
  HullOptions options = with_voxels(0.005);
  options.least_views = 2;
  expect_like_dense_lattice(views, options, box_around(kAside, 0.1));
}

TEST(VisualHull, HoldsTheBallToAPixel) {
  for (const int count : {3, 8}) {
    const double radius_px = 80.0, pixel = kRadius / radius_px;
    const auto views = views_of_ball(count, kCenter, kRadius, 0.8, radius_px);
    const TriangleMesh mesh = visual_hull(views, with_voxels(0.002));
    expect_sound(mesh);
    double farthest = 0.0;
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      const double distance = (vertex - kCenter).norm();
      ASSERT_GT(distance, kRadius - pixel) << count << " views";
      farthest = std::max(farthest, distance);
    }
    // Three views along the axes leave corners out to 1.22 radii, eight leave less.
    EXPECT_LT(farthest, (count == 3 ? 1.28 : 1.2) * kRadius);
    EXPECT_EQ(inspect_topology(mesh).euler_number, 2);
  }
}

TEST(VisualHull, VolumeOfThreeFarViewsIsThatOfThreeCrossedCylinders) {
  // From 200 radii away lines of sight are parallel to half a percent; Steinmetz: 8 (2 - sqrt 2)
  // r^3.
  const double exact = 8.0 * (2.0 - std::sqrt(2.0)) * kRadius * kRadius * kRadius;
  const auto views = views_of_ball(3, kCenter, kRadius, 200.0 * kRadius, 100.0);
  double previous = 1.0;
  for (const double voxel_size : {0.004, 0.002, 0.001}) {
    HullReport report;
    visual_hull(views, with_voxels(voxel_size), &report);
    const double error = std::abs(report.volume / exact - 1.0);
    EXPECT_LT(error, 0.01) << voxel_size;
    EXPECT_LT(error, previous) << voxel_size;
    previous = error;
  }
}

TEST(VisualHull, SimplifiedItKeepsItsVolumeAndFillsTheReport) {
  const auto views = views_of_ball(3, kCenter, kRadius, 0.8, 80.0);
  HullReport report;
  const TriangleMesh mesh = visual_hull(views, with_voxels(0.002, 2000), &report);
  const double fine = enclosed_volume(visual_hull(views, with_voxels(0.002)));
  EXPECT_NEAR(report.volume / fine, 1.0, 0.01);
  EXPECT_EQ(report.triangle_count, mesh.triangles.size());
  EXPECT_LE(report.triangle_count, 2100u);
  EXPECT_GT(report.raw_triangle_count, 10000u);
  EXPECT_EQ(report.levels.front().visited, 1u);
  EXPECT_TRUE(report.region.contains(bounding_box(mesh).center()));
}

TEST(VisualHull, UnknownPixelsCarveNothingAndAreMarked) {
  auto views = views_of_ball(3, kCenter, kRadius, 0.8, 60.0);
  const TriangleMesh whole = visual_hull(views, with_voxels(0.002));
  EXPECT_TRUE(whole.unproven.empty());
  // Something stands before the left half of the ball in the first view.
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 140; ++x) views[0].silhouette(x, y) = PixelLabel::unknown;
  }
  const TriangleMesh masked = visual_hull(views, with_voxels(0.002));
  ASSERT_EQ(masked.unproven.size(), masked.vertices.size());
  EXPECT_GT(enclosed_volume(masked), enclosed_volume(whole));
  const NearestSurface grown(masked);
  for (const Eigen::Vector3d& vertex : whole.vertices) {
    const double outward = (vertex - kCenter).norm();
    const auto match = grown.nearest(vertex);
    EXPECT_TRUE(match.distance < 0.002 || (match.point - kCenter).norm() > outward - 0.002);
  }
  std::size_t marked = 0;
  for (std::size_t v = 0; v < masked.vertices.size(); ++v) {
    const auto pixel = project(views[0].camera, masked.vertices[v]);
    ASSERT_TRUE(pixel.has_value());
    const double beyond = pixel->x() - 140.0;
    if (std::abs(beyond) > 4.0) {
      EXPECT_EQ(masked.unproven[v], beyond < 0.0 ? 1 : 0) << pixel->transpose();
    }
    marked += masked.unproven[v];
  }
  EXPECT_GT(marked, 100u);
}

TEST(VisualHull, APixelOutOfFrameSaysNothing) {
  auto views = views_of_ball(3, kCenter, kRadius, 0.8, 60.0);
  const TriangleMesh whole = visual_hull(views, with_voxels(0.002));
  // A fourth camera that sees half of the ball at its picture's edge cuts nothing off.
  const Camera aside = camera_at("aside", kCenter + Eigen::Vector3d(-0.5, 0.0, -0.6),
                                 kCenter + Eigen::Vector3d(0.1, 0.0, -0.09), 60.0 * 0.78 / kRadius);
  views.push_back({aside, ball_silhouette(aside, kCenter, kRadius)});
  const auto middle = project(aside, kCenter);
  ASSERT_TRUE(middle.has_value());
  ASSERT_GT(std::abs(middle->x() - 160.0), 130.0);
  ASSERT_GT(count_pixels(views.back().silhouette, PixelLabel::hand), 500u);
  const TriangleMesh mesh = visual_hull(views, with_voxels(0.002));
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    EXPECT_GT((vertex - kCenter).norm(), kRadius * (1.0 - 1.0 / 60.0));
  }
  EXPECT_LE(enclosed_volume(mesh), enclosed_volume(whole) * 1.001);
}

TEST(VisualHull, ADissentingViewIsOverruledOnlyWhereAllowed) {
  auto views = views_of_ball(6, kCenter, kRadius, 0.8, 60.0);
  HullOptions options = with_voxels(0.002);
  options.dissenting_views = 1;
  const TriangleMesh lenient = visual_hull(views, options);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 160; ++x) views[1].silhouette(x, y) = PixelLabel::background;
  }
  const double cut = enclosed_volume(visual_hull(views, with_voxels(0.002)));
  const TriangleMesh overruled = visual_hull(views, options);
  EXPECT_LT(cut, 0.7 * enclosed_volume(overruled));
  EXPECT_LE(enclosed_volume(overruled), enclosed_volume(lenient) * 1.001);
  for (const Eigen::Vector3d& vertex : overruled.vertices) {
    EXPECT_GT((vertex - kCenter).norm(), kRadius * (1.0 - 1.0 / 60.0));
  }
}

TEST(VisualHull, NamesTheViewWhoseSilhouetteIsEmpty) {
  auto views = views_of_ball(3, kCenter, kRadius, 0.8, 60.0);
  views[1].silhouette = Silhouette(320, 240, PixelLabel::background);
  EXPECT_NE(error_of(views).find("'view_1'"), std::string::npos) << error_of(views);
  EXPECT_NE(error_of(views).find("all background"), std::string::npos);
  EXPECT_EQ(error_of(views).find("view_0"), std::string::npos);
}

TEST(VisualHull, NamesTheViewThatContradictsTheOthers) {
  auto views = views_of_ball(6, kCenter, kRadius, 0.8, 60.0);
  views[2].silhouette =
      ball_silhouette(views[2].camera,
                      kCenter + views[2].camera.camera_from_world.rotation.conjugate() *
                                    Eigen::Vector3d(0.09, 0.0, 0.0),
                      0.2 * kRadius);
  const std::string message = error_of(views);
  EXPECT_NE(message.find("without 'view_2' something"), std::string::npos) << message;
  EXPECT_EQ(message.find("view_1"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(VisualHull, NamesBothOfTwoViewsThatContradictEachOther) {
  auto views = views_of_ball(2, kCenter, kRadius, 0.8, 60.0);
  views[0].silhouette =
      ball_silhouette(views[0].camera, kCenter + Eigen::Vector3d(0.0, 0.0, 0.06), 0.3 * kRadius);
  views[1].silhouette =
      ball_silhouette(views[1].camera, kCenter - Eigen::Vector3d(0.0, 0.0, 0.06), 0.3 * kRadius);
  const std::string message = error_of(views);
  EXPECT_NE(message.find("'view_0' and 'view_1'"), std::string::npos) << message;
}

TEST(VisualHull, RefusesViewsAndOptionsThatMakeNoSense) {
  const auto views = views_of_ball(3, kCenter, kRadius, 0.8, 60.0);
  auto bad = views;
  bad[1].camera.distortion[0] = 0.1;
  EXPECT_NE(error_of(bad).find("'view_1'"), std::string::npos);
  bad = views;
  bad[2].silhouette = Silhouette(240, 320, PixelLabel::hand);
  EXPECT_NE(error_of(bad).find("240 x 320"), std::string::npos);
  bad = views;
  for (HullView& view : bad) view.silhouette = Silhouette(320, 240, PixelLabel::unknown);
  EXPECT_NE(error_of(bad).find("hand"), std::string::npos);
  EXPECT_NE(error_of({views[0]}), "");
  EXPECT_NE(error_of(views, with_voxels(0.0)), "");
  EXPECT_NE(error_of(views, with_voxels(1e-9)), "");
  EXPECT_NE(error_of(views, {.dissenting_views = 2, .least_views = 2}), "");
  EXPECT_NE(error_of(views, {.least_views = 4}), "");
  EXPECT_NE(error_of(views, {.least_views = -1}), "");
}

TEST(VisualHull, SaysWhenTheObjectIsThinnerThanAVoxel) {
  // Two small balls, so that no corner of a coarse lattice around both lies in either.
  auto views = views_of_ball(3, kCenter, kRadius, 0.8, 60.0);
  for (HullView& view : views) {
    view.silhouette =
        ball_silhouette(view.camera, kCenter - Eigen::Vector3d(0.03, 0.04, 0.06), 0.006);
    const Silhouette other =
        ball_silhouette(view.camera, kCenter + Eigen::Vector3d(0.03, 0.04, 0.06), 0.006);
    for (std::size_t i = 0; i < other.pixel_count(); ++i) {
      if (other.values()[i] == PixelLabel::hand) view.silhouette.values()[i] = PixelLabel::hand;
    }
  }
  EXPECT_NE(error_of(views, with_voxels(0.1)).find("thinner than a voxel"), std::string::npos);
  EXPECT_EQ(error_of(views, with_voxels(0.002)), "");
}

TEST(FindRegion, HoldsTheHullAndLittleMore) {
  for (const int count : {2, 3, 8}) {
    const auto views = views_of_ball(count, kCenter, kRadius, 0.8, 60.0);
    const Eigen::AlignedBox3d region = find_region(views, {});
    const TriangleMesh mesh = visual_hull(views, with_voxels(0.003));
    // Carved from a much wider box, the hull is the same.
    const TriangleMesh wide =
        extract_isosurface(carve(views, box_around(kCenter, 0.7), with_voxels(0.003)));
    EXPECT_NEAR(enclosed_volume(wide) / enclosed_volume(mesh), 1.0, 0.01);
    const Eigen::AlignedBox3d box = bounding_box(wide);
    EXPECT_TRUE(region.contains(box)) << count << " views";
    EXPECT_LT(region.sizes().maxCoeff(), 1.25 * box.sizes().maxCoeff()) << count << " views";
  }
}

TEST(FindRegion, FindsWhatFacingCamerasSeeThoughTheySeeEachOther) {
  std::vector<HullView> views;
  for (const double side : {-1.0, 1.0}) {
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitY().eval()}) {
      const Camera camera = camera_at("view_" + std::to_string(views.size()),
                                      kCenter + 0.5 * side * axis, kCenter, 400.0);
      views.push_back({camera, ball_silhouette(camera, kCenter, kRadius)});
    }
  }
  EXPECT_LT(find_region(views, {}).sizes().maxCoeff(), 0.15);
}

TEST(FindRegion, EndsWhereSilhouettesHaveNoEnd) {
  std::vector<HullView> views;
  for (const double x : {-0.05, 0.05}) {
    const Eigen::Vector3d from(x, 0.0, 0.0);
    views.push_back(
        {camera_at("at_" + std::to_string(x), from, from + Eigen::Vector3d(0.0, 0.0, 1.0), 300.0),
         Silhouette(320, 240, PixelLabel::hand)});
  }
  const Eigen::AlignedBox3d region = find_region(views, {});
  EXPECT_FALSE(region.isEmpty());
  EXPECT_LT(region.sizes().maxCoeff(), 10.0);
}

TEST(VisualHull, IsTheSameWhereverTheSceneStandsAndWhateverItsScale) {
  const auto views = views_of_ball(4, kCenter, kRadius, 0.8, 80.0);
  const TriangleMesh here = visual_hull(views, with_voxels(0.002));
  const NearestSurface surface(here);
  const Eigen::Vector3d offset(100.0, -70.0, 40.0);
  for (const double scale : {1.0, 10.0}) {
    std::vector<HullView> moved = views;
    for (HullView& view : moved) {
      Rigid3d& pose = view.camera.camera_from_world;
      pose.translation = scale * pose.translation - pose.rotation * offset;
    }
    const TriangleMesh there = visual_hull(moved, with_voxels(0.002 * scale));
    const double size = scale * scale * scale;
    EXPECT_NEAR(enclosed_volume(there) / size / enclosed_volume(here), 1.0, 2e-3);
    // The lattices may lie differently, which shows at the hull's edges: up to a voxel.
    double sum = 0.0;
    for (const Eigen::Vector3d& vertex : there.vertices) {
      const double distance = surface.nearest((vertex - offset) / scale).distance;
      ASSERT_LT(distance, 2e-3);
      sum += distance;
    }
    EXPECT_LT(sum / static_cast<double>(there.vertices.size()), 1e-4);
  }
}

}  // namespace
}  // namespace tegata
