// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/octree.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr double kOctreeBallRadius = 0.05;

double ball(const Eigen::Vector3d& point) { return kOctreeBallRadius - point.norm(); }

// A ball; the field changes by 1 m per metre, so its value at a cube's middle bounds the rest.
FieldSource ball_source(std::map<std::array<double, 3>, int>* samples = nullptr) {
  return {.classify =
              [](const Eigen::AlignedBox3d& cube) {
                const double reach = 0.5 * cube.diagonal().norm();
                const double middle = ball(cube.center());
                if (middle > reach) return Occupancy::inside;
                return middle < -reach ? Occupancy::outside : Occupancy::mixed;
              },
          .sample =
              [samples](const Eigen::Vector3d& point, bool& unproven) {
                if (samples != nullptr) ++(*samples)[{point.x(), point.y(), point.z()}];
                unproven = point.x() > 0.0;
                return static_cast<float>(ball(point));
              }};
}

const Eigen::AlignedBox3d kRegion(Eigen::Vector3d(-0.05, -0.05, -0.05),
                                  Eigen::Vector3d(0.05, 0.05, 0.05));

Eigen::Vector3d corner_point(const SparseField& field, const OctreeLeaf& leaf, int corner) {
  return field.origin + field.cell_size * Eigen::Vector3d(leaf.index[0] + (corner & 1),
                                                          leaf.index[1] + (corner >> 1 & 1),
                                                          leaf.index[2] + (corner >> 2));
}

// How many corners of a cell of the lattice lie in the ball.
int corners_inside(const SparseField& field, const LatticeIndex& index) {
  const OctreeLeaf cell{.index = index, .field = {}};
  int inside = 0;
  for (int i = 0; i < 8; ++i) {
    inside += static_cast<float>(ball(corner_point(field, cell, i))) > 0.0f ? 1 : 0;
  }
  return inside;
}

TEST(Octree, KeepsExactlyTheCellsThatADenseLatticeWouldKeep) {
  const SparseField field = build_octree(kRegion, 0.003, ball_source());
  std::set<LatticeIndex> kept;
  for (const OctreeLeaf& leaf : field.leaves) {
    ASSERT_TRUE(kept.insert(leaf.index).second) << "a leaf twice";
    for (int i = 0; i < 8; ++i) {
      ASSERT_EQ(leaf.field[static_cast<std::size_t>(i)],
                static_cast<float>(ball(corner_point(field, leaf, i))));
    }
  }
  const std::int32_t cells = 1 << (field.levels.size() - 1);
  std::size_t expected = 0;
  for (std::int32_t x = 0; x < cells; ++x) {
    for (std::int32_t y = 0; y < cells; ++y) {
      for (std::int32_t z = 0; z < cells; ++z) {
        const int inside = corners_inside(field, {x, y, z});
        const bool is_crossed = inside > 0 && inside < 8;
        ASSERT_EQ(kept.contains({x, y, z}), is_crossed);
        expected += is_crossed ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(kept.size(), expected);
  EXPECT_GT(expected, 1000u);
}

TEST(Octree, SamplesEachLatticePointOnce) {
  std::map<std::array<double, 3>, int> samples;
  build_octree(kRegion, 0.004, ball_source(&samples));
  EXPECT_GT(samples.size(), 1000u);
  for (const auto& [point, count] : samples) ASSERT_EQ(count, 1);
}

TEST(Octree, GivesTheSameLeavesInTheSameOrderEveryTime) {
  const SparseField a = build_octree(kRegion, 0.004, ball_source());
  const SparseField b = build_octree(kRegion, 0.004, ball_source());
  ASSERT_EQ(a.leaves.size(), b.leaves.size());
  for (std::size_t i = 0; i < a.leaves.size(); ++i) {
    EXPECT_EQ(a.leaves[i].index, b.leaves[i].index);
    EXPECT_EQ(a.leaves[i].field, b.leaves[i].field);
  }
}

TEST(Octree, LevelsAddUp) {
  const SparseField field = build_octree(kRegion, 0.003, ball_source());
  ASSERT_EQ(field.levels.front().visited, 1u);
  for (std::size_t i = 0; i + 1 < field.levels.size(); ++i) {
    const auto& level = field.levels[i];
    EXPECT_EQ(field.levels[i + 1].visited, 8 * (level.visited - level.inside - level.outside));
  }
  const auto& last = field.levels.back();
  EXPECT_EQ(field.leaves.size(), last.visited - last.inside - last.outside);
}

TEST(Octree, ClosesASolidThatFillsItsCube) {
  const FieldSource everything = {
      .classify = [](const Eigen::AlignedBox3d&) { return Occupancy::inside; },
      .sample = [](const Eigen::Vector3d&, bool&) { return 1.0f; }};
  const SparseField field = build_octree(kRegion, 0.02, everything);
  const std::int32_t last = (1 << (field.levels.size() - 1)) - 1;
  // All cells along the six faces of the cube, and none other.
  EXPECT_EQ(field.leaves.size(), static_cast<std::size_t>((last + 1) * (last + 1) * (last + 1) -
                                                          (last - 1) * (last - 1) * (last - 1)));
  for (const OctreeLeaf& leaf : field.leaves) {
    for (int i = 0; i < 8; ++i) {
      bool is_on_face = false;
      for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t at = leaf.index[static_cast<std::size_t>(axis)] + (i >> axis & 1);
        is_on_face = is_on_face || at == 0 || at == last + 1;
      }
      ASSERT_EQ(leaf.field[static_cast<std::size_t>(i)] < 0.0f, is_on_face);
    }
  }
}

TEST(Octree, MarksLeavesWithAnUnprovenCornerInside) {
  const SparseField field = build_octree(kRegion, 0.004, ball_source());
  for (const OctreeLeaf& leaf : field.leaves) {
    bool expected = false;
    for (int i = 0; i < 8; ++i) {
      const bool inside = leaf.field[static_cast<std::size_t>(i)] > 0.0f;
      expected = expected || (inside && corner_point(field, leaf, i).x() > 0.0);
    }
    ASSERT_EQ(leaf.unproven, expected);
  }
}

TEST(Octree, LeavesACellOfMarginAroundTheRegion) {
  for (const double cell_size : {0.1, 0.05, 0.0125, 0.2, 0.0331}) {
    const SparseField field = build_octree(kRegion, cell_size, ball_source());
    const double side = cell_size * (1 << (field.levels.size() - 1));
    EXPECT_LE(field.origin.x(), kRegion.min().x() - cell_size * (1.0 - 1e-9));
    EXPECT_GE(field.origin.x() + side, kRegion.max().x() + cell_size * (1.0 - 1e-9));
  }
}

TEST(Octree, RefusesRegionsAndCellsThatMakeNoSense) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(build_octree(kRegion, 0.0, ball_source()), Error);
  EXPECT_THROW(build_octree(kRegion, -1.0, ball_source()), Error);
  EXPECT_THROW(build_octree(kRegion, kInfinity, ball_source()), Error);
  EXPECT_THROW(build_octree(kRegion, 1e-9, ball_source()), Error);
  EXPECT_THROW(build_octree(Eigen::AlignedBox3d(), 0.01, ball_source()), Error);
  Eigen::AlignedBox3d unbounded = kRegion;
  unbounded.max().y() = kInfinity;
  EXPECT_THROW(build_octree(unbounded, 0.01, ball_source()), Error);
}

}  // namespace
}  // namespace tegata
