// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/leaf_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tegata/hull/marching_cubes.h"

namespace tegata {
namespace {

struct Ball {
  Eigen::Vector3d center;
  double radius = 0.0;
};

// The field of balls, of which the last is hollowed out of the others.
SparseField field_of(const std::vector<Ball>& balls, bool last_is_hollow = false) {
  const auto value = [&](const Eigen::Vector3d& point) {
    double field = -1.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double depth = balls[i].radius - (point - balls[i].center).norm();
      const bool is_hollow = last_is_hollow && i + 1 == balls.size();
      field = is_hollow ? std::min(field, -depth) : std::max(field, depth);
    }
    return field;
  };
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-1.0, -1.0, -1.0),
                                   Eigen::Vector3d(1.0, 1.0, 1.0));
  return build_octree(region, 0.05,
                      {.classify = [](const Eigen::AlignedBox3d&) { return Occupancy::mixed; },
                       .sample = [&](const Eigen::Vector3d& point,
                                     bool&) { return static_cast<float>(value(point)); }});
}

MeshTopology topology_of(const SparseField& field) {
  return inspect_topology(extract_isosurface(field));
}

TEST(LeafComponents, SmallPiecesGoAndLargeOnesStayWhole) {
  const Ball large{{-0.4, 0.0, 0.0}, 0.5}, middling{{0.5, 0.5, 0.5}, 0.25};
  const Ball small{{0.6, -0.6, 0.0}, 0.1};
  const SparseField all = field_of({large, middling, small});
  ASSERT_EQ(topology_of(all).component_count, 3);
  const SparseField two = without_small_components(all, 0.15);
  const MeshTopology topology = topology_of(two);
  EXPECT_EQ(topology.component_count, 2);
  EXPECT_EQ(topology.euler_number, 4);
  EXPECT_TRUE(topology.closed && topology.oriented && topology.manifold);
  EXPECT_EQ(topology_of(without_small_components(all, 0.5)).component_count, 1);
  EXPECT_EQ(without_small_components(all, 0.0).leaves.size(), all.leaves.size());
}

TEST(LeafComponents, AHollowIsAPieceOfItsOwn) {
  const SparseField shell = field_of({{{0.0, 0.0, 0.0}, 0.8}, {{0.1, 0.0, 0.0}, 0.2}}, true);
  ASSERT_EQ(topology_of(shell).component_count, 2);
  const MeshTopology filled = topology_of(without_small_components(shell, 0.2));
  EXPECT_EQ(filled.component_count, 1);
  EXPECT_TRUE(filled.closed && filled.manifold);
}

TEST(LeafComponents, KeepsTheOrderAndTheRootOfTheField) {
  const SparseField all = field_of({{{-0.4, 0.0, 0.0}, 0.5}, {{0.6, 0.6, 0.6}, 0.1}});
  const SparseField large = without_small_components(all, 0.5);
  EXPECT_EQ(large.origin, all.origin);
  EXPECT_EQ(large.cell_size, all.cell_size);
  EXPECT_EQ(large.levels.size(), all.levels.size());
  ASSERT_LT(large.leaves.size(), all.leaves.size());
  auto next = all.leaves.begin();
  for (const OctreeLeaf& leaf : large.leaves) {
    next = std::find_if(next, all.leaves.end(),
                        [&](const OctreeLeaf& other) { return other.index == leaf.index; });
    ASSERT_NE(next, all.leaves.end());
  }
}

TEST(LeafComponents, AFieldWithoutLeavesStaysOne) {
  EXPECT_TRUE(without_small_components(SparseField{}, 0.5).leaves.empty());
}

}  // namespace
}  // namespace tegata
