// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/held_object.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tegata {
namespace {

std::vector<HeldObject> some_objects() {
  return {{HeldObject::Shape::cylinder, {0.025, 0.025, 0.06}},
          {HeldObject::Shape::sphere, {0.035, 0.035, 0.035}},
          {HeldObject::Shape::block, {0.01, 0.012, 0.02}}};
}

TEST(HeldObject, SurfaceIsClosedAndTurnedOutwards) {
  const std::vector<double> volumes = {std::numbers::pi * 0.025 * 0.025 * 0.12,
                                       4.0 / 3.0 * std::numbers::pi * std::pow(0.035, 3),
                                       8.0 * 0.01 * 0.012 * 0.02};
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const TriangleMesh mesh = object_surface(some_objects()[i], 0.0035);
    const MeshTopology topology = inspect_topology(mesh);
    EXPECT_TRUE(topology.closed && topology.oriented && topology.manifold) << i;
    EXPECT_EQ(topology.euler_number, 2) << i;
    EXPECT_NEAR(enclosed_volume(mesh) / volumes[i], 1.0, 0.01) << i;
  }
}

TEST(HeldObject, NoEdgeIsLongerThanAskedFor) {
  for (const HeldObject& object : some_objects()) {
    const TriangleMesh mesh = object_surface(object, 0.0035);
    double longest = 0.0;
    for (const Triangle& triangle : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        longest = std::max(
            longest, (mesh.vertices[triangle[k]] - mesh.vertices[triangle[(k + 1) % 3]]).norm());
      }
    }
    EXPECT_LE(longest, 0.0035);
  }
}

TEST(HeldObject, SurfaceLiesWhereTheDistanceIsZero) {
  for (const HeldObject& object : some_objects()) {
    for (const Eigen::Vector3d& vertex : object_surface(object, 0.005).vertices) {
      ASSERT_NEAR(signed_distance(object, vertex), 0.0, 1e-12);
    }
  }
}

TEST(HeldObject, DistanceIsSignedAndExactBeyondEdges) {
  const HeldObject cylinder{HeldObject::Shape::cylinder, {0.02, 0.02, 0.05}};
  EXPECT_NEAR(signed_distance(cylinder, {0.0, 0.0, 0.0}), -0.02, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, {0.05, 0.0, 0.09}), 0.05, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, {0.0, 0.0, 0.06}), 0.01, 1e-12);
  const HeldObject block{HeldObject::Shape::block, {0.01, 0.02, 0.03}};
  EXPECT_NEAR(signed_distance(block, {0.0, 0.0, 0.029}), -0.001, 1e-12);
  EXPECT_NEAR(signed_distance(block, {-0.04, 0.06, 0.0}), 0.05, 1e-12);
}

}  // namespace
}  // namespace tegata
