// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/bone_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/hand/built_in_hand.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

const HandModel& coarse_hand() {
  static const HandModel hand =
      built_in_hand({}, Side::right, {.cell_size = 0.004, .triangle_count = 1500});
  return hand;
}

TEST(BonePieces, AreClosedAndMakeUpTheHand) {
  for (const HandModel& hand : {coarse_hand(), mirrored(coarse_hand())}) {
    double volume = 0.0;
    for (const TriangleMesh& piece : bone_pieces(hand)) {
      const MeshTopology topology = inspect_topology(piece);
      EXPECT_TRUE(topology.closed && topology.oriented);
      EXPECT_GT(enclosed_volume(piece), 2e-7);
      volume += enclosed_volume(piece);
    }
    EXPECT_NEAR(volume, enclosed_volume(hand.rest_surface), 1e-9);
  }
}

TEST(BonePieces, LieOnTheSurfaceAgainAtTheRestAngles) {
  const HandModel& hand = coarse_hand();
  const auto pieces = bone_pieces(hand);
  const auto bones = bone_transforms(hand.skeleton, hand.rest_angles);
  std::size_t matched = 0;
  for (std::size_t bone = 0; bone < pieces.size(); ++bone) {
    for (const Eigen::Vector3d& vertex : pieces[bone].vertices) {
      const Eigen::Vector3d at_rest = bones[bone] * vertex;
      matched += static_cast<std::size_t>(
          std::any_of(hand.rest_surface.vertices.begin(), hand.rest_surface.vertices.end(),
                      [&](const auto& other) { return (other - at_rest).norm() < 1e-9; }));
    }
  }
  EXPECT_GE(matched, hand.rest_surface.vertices.size());
}

TEST(BonePieces, OpenHandIsClosed) {
  HandModel open = coarse_hand();
  // The lowest triangle is one of the stump's end.
  const auto lowest = [&](const Triangle& triangle) {
    double sum = 0.0;
    for (const std::uint32_t corner : triangle) sum += open.rest_surface.vertices[corner].y();
    return sum;
  };
  auto& triangles = open.rest_surface.triangles;
  triangles.erase(std::min_element(
      triangles.begin(), triangles.end(),
      [&](const Triangle& a, const Triangle& b) { return lowest(a) < lowest(b); }));
  EXPECT_FALSE(inspect_topology(open.rest_surface).closed);
  EXPECT_TRUE(inspect_topology(bone_pieces(open)[0]).closed);
}

/// A box of edges a, b, c, turned and moved.
TriangleMesh box(const Eigen::Vector3d& edges, const Rigid3d& place) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1U) - 0.5, (i >> 1U & 1U) - 0.5, (i >> 2U) - 0.5);
    mesh.vertices.push_back(place * Eigen::Vector3d(corner.cwiseProduct(edges)));
  }
  for (const Triangle& triangle : std::vector<Triangle>{{0, 2, 1},
                                                        {1, 2, 3},
                                                        {4, 5, 6},
                                                        {5, 7, 6},
                                                        {0, 1, 4},
                                                        {1, 5, 4},
                                                        {2, 6, 3},
                                                        {3, 6, 7},
                                                        {0, 4, 2},
                                                        {2, 4, 6},
                                                        {1, 3, 5},
                                                        {3, 7, 5}}) {
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

TEST(SolidMass, IsThatOfABox) {
  const Eigen::Vector3d edges(0.02, 0.05, 0.03);
  const Rigid3d place{so3_exp({0.3, -0.7, 1.1}), {0.4, -0.2, 0.1}};
  const MassProperties solid = solid_mass(box(edges, place), 1100.0);
  const double mass = 1100.0 * edges.prod();
  EXPECT_NEAR(solid.mass, mass, 1e-12);
  EXPECT_LT((solid.center - place.translation).norm(), 1e-12);
  const Eigen::Vector3d squares = edges.cwiseAbs2();
  const Eigen::Vector3d moments =
      mass / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  const Eigen::Matrix3d turn = place.rotation.toRotationMatrix();
  EXPECT_LT((solid.inertia - turn * moments.asDiagonal() * turn.transpose()).norm(), 1e-15);
}

TEST(SolidMass, OfABallIsTwoFifths) {
  const double density = 1000.0, radius = 0.01;
  const double mass = density * 4.0 / 3.0 * 3.14159265358979 * radius * radius * radius;
  const MassProperties ball = ball_mass({1.0, 2.0, 3.0}, mass, density);
  EXPECT_NEAR(ball.inertia(1, 1), 0.4 * mass * radius * radius, 1e-18);
  EXPECT_EQ(ball.inertia(0, 1), 0.0);
}

}  // namespace
}  // namespace tegata
