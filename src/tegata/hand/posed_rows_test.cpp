// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/posed_rows.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tegata/hand/test_hand.h"

namespace tegata {
namespace {

// Vertices and normals as their definition says, about the hand's origin.
struct PlainHand {
  PlainHand(const HandModel& model, const HandPose& pose) {
    const auto to = bone_transforms(model.skeleton, pose.angles);
    const auto from = bone_transforms(model.skeleton, model.rest_angles);
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
      for (std::size_t j = 0; j < 4; ++j) {
        const auto bone = static_cast<std::size_t>(model.links[i].bones[j]);
        const Rigid3d moved = to[bone] * from[bone].inverse();
        point += model.links[i].weights[j] * (moved * model.rest_surface.vertices[i]);
        normal += model.links[i].weights[j] * (moved.rotation * model.rest_surface.normals[i]);
      }
      points.push_back(pose.world_from_hand.rotation * point);
      normals.push_back((pose.world_from_hand.rotation * normal).normalized());
    }
  }
  std::vector<Eigen::Vector3d> points, normals;
};

Eigen::Vector3d at(const RowPoints& points, std::size_t row) {
  const std::size_t lane = row % kRowLanes;
  return {points[0][lane], points[1][lane], points[2][lane]};
}

bool same_bits(const PosedRows& a, const PosedRows& b) {
  const SkinRows& rows = a.rows();
  for (std::size_t block = 0; block < rows.blocks().size(); ++block) {
    if (std::memcmp(&a.points(block), &b.points(block), sizeof(PosedPoints)) != 0) return false;
  }
  for (std::size_t block = 0; block < rows.parts()[kDigitCount - 1].last; ++block) {
    if (std::memcmp(&a.columns(block), &b.columns(block), sizeof(AngleColumns)) != 0) return false;
  }
  return true;
}

TEST(PosedRows, EveryInstructionSetGivesThePlainAnswer) {
  for (const HandModel& model : hands_to_check()) {
    const auto rows = std::make_shared<const SkinRows>(model);
    for (const HandPose& pose : poses_to_check(model)) {
      const PlainHand plain(model, pose);
      for (const InstructionSet set : kInstructionSets) {
        if (!is_supported(set)) continue;
        PosedRows posed(rows, model);
        posed.move_to(pose, set);
        for (std::size_t i = 0; i < plain.points.size(); ++i) {
          const std::size_t row = rows->first_row(i);
          const PosedPoints& points = posed.points(row / kRowLanes);
          EXPECT_LT((at(points.position, row) - plain.points[i]).norm(), 1e-14) << i;
          EXPECT_LT((at(points.normal, row) - plain.normals[i]).norm(), 1e-13) << i;
        }
      }
    }
  }
}

TEST(PosedRows, EveryInstructionSetGivesTheSameBits) {
  for (const HandModel& model : hands_to_check()) {
    const auto rows = std::make_shared<const SkinRows>(model);
    for (const HandPose& pose : poses_to_check(model)) {
      PosedRows baseline(rows, model);
      baseline.move_to(pose, InstructionSet::baseline);
      for (const InstructionSet set : kInstructionSets) {
        if (!is_supported(set)) continue;
        PosedRows posed(rows, model);
        posed.move_to(pose, set);
        EXPECT_TRUE(same_bits(posed, baseline)) << instruction_set_name(set);
        for (std::size_t block = 0; block < rows->parts()[kDigitCount - 1].last; ++block) {
          EXPECT_EQ(posed.normal_columns(block, set),
                    baseline.normal_columns(block, InstructionSet::baseline))
              << instruction_set_name(set);
        }
      }
    }
  }
}

TEST(PosedRows, AllRowsOfASharedVertexSayWhereItIs) {
  const HandModel model = tangled_hand();
  PosedRows posed(std::make_shared<const SkinRows>(model), model);
  posed.move_to(random_pose(7));
  for (const SkinRows::SharedVertex& shared : posed.rows().shared()) {
    const std::size_t first = shared.rows.front();
    for (const std::size_t row : shared.rows) {
      EXPECT_EQ(at(posed.points(row / kRowLanes).position, row),
                at(posed.points(first / kRowLanes).position, first));
      EXPECT_EQ(at(posed.points(row / kRowLanes).normal, row),
                at(posed.points(first / kRowLanes).normal, first));
    }
  }
}

TEST(PosedRows, FarFromTheWorldsOriginNothingIsLost) {
  const HandModel model = test_hand();
  const auto rows = std::make_shared<const SkinRows>(model);
  PosedRows near(rows, model), far(rows, model);
  HandPose pose = random_pose(3);
  near.move_to(pose);
  pose.world_from_hand.translation += Eigen::Vector3d(100.0, -100.0, 1e6);
  far.move_to(pose);
  EXPECT_TRUE(same_bits(near, far));
}

TEST(PosedRows, PosesAreForgottenWithTheNext) {
  const HandModel model = tangled_hand();
  const auto rows = std::make_shared<const SkinRows>(model);
  PosedRows moved(rows, model), fresh(rows, model);
  moved.move_to(random_pose(1));
  moved.move_to(random_pose(2));
  fresh.move_to(random_pose(2));
  EXPECT_TRUE(same_bits(moved, fresh));
}

TEST(PosedRows, ANormalOfNoLengthStaysZero) {
  HandModel model = test_hand();
  for (Eigen::Vector3d& normal : model.rest_surface.normals) normal.setZero();
  PosedRows posed(std::make_shared<const SkinRows>(model), model);
  posed.move_to(random_pose(4));
  for (std::size_t block = 0; block < posed.rows().blocks().size(); ++block) {
    EXPECT_EQ(posed.points(block).normal, RowPoints{});
  }
  for (std::size_t block = 0; block < posed.rows().parts()[kDigitCount - 1].last; ++block) {
    EXPECT_EQ(posed.normal_columns(block), AngleColumns{});
  }
}

}  // namespace
}  // namespace tegata
