// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_rows.h"

#include <gtest/gtest.h>

#include "tegata/hand/skin_motion.h"
#include "tegata/hand/test_hand.h"

namespace tegata {
namespace {

// The rows of a vertex.
std::vector<std::uint32_t> rows_of(const SkinRows& rows, std::size_t vertex) {
  const SkinRows::SharedVertex* const shared = rows.shared(vertex);
  if (shared != nullptr) return shared->rows;
  return {static_cast<std::uint32_t>(rows.first_row(vertex))};
}

TEST(SkinRows, RowsOfAVertexAddUpToItsLinks) {
  for (const HandModel& model : hands_to_check()) {
    const SkinRows rows(model);
    ASSERT_EQ(rows.vertex_count(), model.links.size());
    for (std::size_t vertex = 0; vertex < rows.vertex_count(); ++vertex) {
      std::array<double, kBoneCount> expected = {}, found = {};
      for (std::size_t i = 0; i < 4; ++i) {
        expected[static_cast<std::size_t>(model.links[vertex].bones[i])] +=
            model.links[vertex].weights[i];
      }
      for (const std::uint32_t row : rows_of(rows, vertex)) {
        const SkinRows::Block& block = rows.blocks()[row / kRowLanes];
        const std::size_t part = rows.part_of_row(row), lane = row % kRowLanes;
        for (std::size_t i = 0; i < 4; ++i) {
          if (part == SkinRows::kPalmPart && i > 0) {
            EXPECT_EQ(block.weights[i][lane], 0.0);
          } else {
            found[i == 0 ? 0 : 3 * part + i] += block.weights[i][lane];
          }
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto at = static_cast<Eigen::Index>(axis);
          EXPECT_EQ(block.position[axis][lane], model.rest_surface.vertices[vertex][at]);
          EXPECT_EQ(block.normal[axis][lane], model.rest_surface.normals[vertex][at]);
        }
      }
      EXPECT_EQ(found, expected) << model.name << " " << vertex;
    }
  }
}

TEST(SkinRows, OnlyVerticesThatSeveralDigitsMoveAreShared) {
  EXPECT_TRUE(SkinRows(test_hand()).shared().empty());
  const HandModel model = tangled_hand();
  const SkinRows rows(model);
  EXPECT_FALSE(rows.shared().empty());
  for (const SkinRows::SharedVertex& shared : rows.shared()) {
    EXPECT_GE(shared.rows.size(), 2u);
    EXPECT_EQ(shared.vertex % 7, 0u);
    EXPECT_EQ(rows.first_row(shared.vertex), shared.rows.front());
  }
}

TEST(SkinRows, PartsFollowEachOtherAndRepeatTheirLastRow) {
  const SkinRows rows(test_hand());
  std::size_t next = 0;
  for (const SkinRows::Part& part : rows.parts()) {
    EXPECT_EQ(part.first, next);
    ASSERT_LT(part.first, part.last);
    next = part.last;
    // 18 vertices a digit (three octahedra) and 6 of the palm: no block is full at its end.
    const SkinRows::Block& last = rows.blocks()[part.last - 1];
    EXPECT_EQ(last.weights[0][kRowLanes - 1], last.weights[0][kRowLanes - 2]);
    EXPECT_EQ(last.position[1][kRowLanes - 1], last.position[1][kRowLanes - 2]);
  }
  EXPECT_EQ(next, rows.blocks().size());
}

TEST(SkinRows, AnUnusedLinkMakesNoRow) {
  HandModel model = test_hand();
  model.links[0].bones = {0, 5, 9, 12};
  model.links[0].weights = {1.0, 0.0, 0.0, 0.0};
  EXPECT_TRUE(SkinRows(model).shared().empty());
  EXPECT_EQ(SkinRows(model).part_of_row(SkinRows(model).first_row(0)), SkinRows::kPalmPart);
}

// Turned by the two bones about the joint's centre, its arms must lead from there to the vertex.
TEST(SkinRows, ArmsOfAHingedVertexLeadToIt) {
  for (const HandModel& model : hands_to_check()) {
    const SkinRows rows(model);
    HandPose pose;
    pose.angles = random_angles(3);
    const auto vertices = PosedHand(model, pose).vertices();
    SkinMotion motion(model);
    motion.move_to(pose);
    for (std::size_t vertex = 0; vertex < rows.vertex_count(); ++vertex) {
      const std::size_t bone = rows.hinge(vertex);
      if (bone == SkinRows::kNoBone) continue;
      const std::size_t joint = bone == 0 ? 0 : 1 + (bone - 1) % 3;
      const SkinMotion::Digit& digit = motion.digit(bone == 0 ? 0 : (bone - 1) / 3);
      const SkinRows::HingedVertex& hinged = rows.hinged(vertex);
      for (std::size_t i = 0; i < 3; ++i) {
        double found = bone == 0 ? 0.0 : digit.axes[joint].center[i];
        for (std::size_t k = 0; k < 3; ++k) {
          found += digit.bones[joint].turn[i][k] * static_cast<double>(hinged.beyond[k]);
          if (bone == 0) continue;
          found += digit.bones[joint - 1].turn[i][k] * static_cast<double>(hinged.before[k]);
        }
        EXPECT_NEAR(found, vertices[vertex][static_cast<Eigen::Index>(i)], 1e-7) << vertex;
      }
    }
  }
}

TEST(SkinRows, AVertexOfBonesThatAreNotJoinedIsNotHinged) {
  HandModel model = test_hand();
  model.links[0] = {{5, 4, 5, 9}, {0.3, 0.4, 0.3, 0.0}};
  model.links[1] = {{0, 4, 5, 0}, {0.3, 0.4, 0.3, 0.0}};
  model.links[2] = {{4, 6, 0, 0}, {0.5, 0.5, 0.0, 0.0}};
  model.links[3] = {{1, 4, 0, 0}, {0.5, 0.5, 0.0, 0.0}};
  const SkinRows rows(model);
  EXPECT_EQ(rows.hinge(0), 5u);
  for (const std::size_t vertex : {1u, 2u, 3u}) {
    EXPECT_EQ(rows.hinge(vertex), SkinRows::kNoBone) << vertex;
  }
}

}  // namespace
}  // namespace tegata
