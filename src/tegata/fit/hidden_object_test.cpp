// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/hidden_object.h"

#include <gtest/gtest.h>

#include <limits>

#include "tegata/fit/surroundings.h"
#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

constexpr double kRadius = 0.03;

// A ball in the palm of a hand, in the hand's frame.
const Eigen::Vector3d kBall(0.0, 0.085, -0.045);

// A ball as a mesh of rings.
TriangleMesh ball(const Eigen::Vector3d& center, double radius) {
  TriangleMesh mesh;
  constexpr int kRings = 16, kSectors = 24;
  for (int i = 0; i <= kRings; ++i) {
    for (int j = 0; j < kSectors; ++j) {
      const double polar = std::numbers::pi * i / kRings;
      const double azimuth = 2.0 * std::numbers::pi * j / kSectors;
      mesh.vertices.push_back(center + radius * Eigen::Vector3d(std::sin(polar) * std::cos(azimuth),
                                                                std::sin(polar) * std::sin(azimuth),
                                                                std::cos(polar)));
    }
  }
  for (std::uint32_t i = 0; i < kRings; ++i) {
    for (std::uint32_t j = 0; j < kSectors; ++j) {
      const std::uint32_t a = i * kSectors + j, b = i * kSectors + (j + 1) % kSectors;
      mesh.triangles.push_back({a, a + kSectors, b});
      mesh.triangles.push_back({b, a + kSectors, b + kSectors});
    }
  }
  return mesh;
}

struct HidingScene {
  std::vector<FitFrame> frames;
  std::vector<const FitFrame*> pointers;
  HandEstimate truth;
};

// A hand that turns in steps of 18 degrees, about no camera's axis; where a ball of this radius
// stands before it, it is not seen.
HidingScene scene_with_ball(double radius) {
  const HandModel& hand = test::coarse_hand();
  HidingScene scene;
  scene.truth.angles = test::grasping_pose(0.0).angles;
  for (int f = 0; f < 10; ++f) {
    HandPose pose = test::grasping_pose(0.0);
    const Eigen::Quaterniond turn =
        so3_exp(0.314 * f * Eigen::Vector3d(0.5, 0.4, 1.0).normalized());
    pose.world_from_hand = Rigid3d{turn, Eigen::Vector3d::Zero()} * pose.world_from_hand;
    scene.truth.world_from_hand.push_back(pose.world_from_hand);
    const TriangleMesh surface = PosedHand(hand, pose).surface();
    FitFrame frame;
    for (const Camera& camera : test::orthogonal_rig(0.8)) {
      const RenderedMesh seen = render(surface, camera);
      const RenderedMesh hides = render(ball(pose.world_from_hand * kBall, radius), camera);
      Silhouette silhouette(camera.width, camera.height, PixelLabel::background);
      for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
          if (seen.depth(x, y) < hides.depth(x, y)) silhouette(x, y) = PixelLabel::hand;
        }
      }
      frame.views.push_back(make_fit_view(camera, silhouette));
    }
    scene.frames.push_back(std::move(frame));
  }
  for (const FitFrame& frame : scene.frames) scene.pointers.push_back(&frame);
  return scene;
}

TEST(HiddenObject, IsFoundWhereItHidesTheHand) {
  const FitHand hand(test::coarse_hand());
  const HidingScene scene = scene_with_ball(kRadius);
  const HiddenObject object = find_hidden_object(hand, scene.pointers, scene.truth, {}, 0);
  ASSERT_FALSE(object.surface.triangles.empty());
  ASSERT_EQ(object.confidence.size(), object.surface.vertices.size());
  EXPECT_TRUE(inspect_topology(object.surface).closed);
  EXPECT_LT((bounding_box(object.surface).center() - kBall).norm(), 0.02);
  double sum = 0.0;
  for (const Eigen::Vector3d& vertex : object.surface.vertices) {
    sum += std::abs((vertex - kBall).norm() - kRadius);
  }
  EXPECT_LT(sum / static_cast<double>(object.surface.vertices.size()), 0.012);
}

TEST(HiddenObject, WhereNothingHidesTheHandThereIsNone) {
  const FitHand hand(test::coarse_hand());
  const HidingScene scene = scene_with_ball(1e-6);
  const HiddenObject object =
      find_hidden_object(hand, scene.pointers, scene.truth, {.voxel_size = 0.006}, 0);
  EXPECT_TRUE(object.surface.triangles.empty());
}

TEST(HiddenObject, TheNumberOfThreadsChangesNothing) {
  const FitHand hand(test::coarse_hand());
  const HidingScene scene = scene_with_ball(kRadius);
  const std::span<const FitFrame* const> few = std::span(scene.pointers).first(4);
  const HiddenObjectOptions coarse{.voxel_size = 0.008};
  const HiddenObject one = find_hidden_object(hand, few, scene.truth, coarse, 1);
  const HiddenObject two = find_hidden_object(hand, few, scene.truth, coarse, 2);
  EXPECT_EQ(one.surface.vertices, two.surface.vertices);
  EXPECT_EQ(one.confidence, two.confidence);
}

TEST(HiddenObject, OnlyWhatLiesBehindItIsHidden) {
  const FitHand hand(test::coarse_hand());
  const HidingScene scene = scene_with_ball(kRadius);
  HiddenObject object;
  object.surface = ball(kBall, kRadius);
  const std::vector<FitFrame> frames =
      with_surroundings(hand, scene.pointers, scene.truth, object.surface, 0);
  const Camera& camera = frames[0].views[0].camera;
  const Eigen::Vector3d center = scene.truth.world_from_hand[0] * kBall;
  const Eigen::Vector2d pixel = *project(camera, center);
  const double depth = (camera.camera_from_world * center).z();
  EXPECT_TRUE(frames[0].views[0].is_hidden(pixel, depth));
  EXPECT_FALSE(frames[0].views[0].is_hidden(pixel, depth - 2.0 * kRadius));
  EXPECT_FALSE(scene.frames[0].views[0].is_hidden(pixel, depth));
}

}  // namespace
}  // namespace tegata
