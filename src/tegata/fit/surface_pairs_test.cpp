// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_pairs.h"

#include <gtest/gtest.h>

#include "tegata/base/random.h"
#include "tegata/fit/surface_row.h"
#include "tegata/fit/test_scene.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

// Some vertices move with several digits or with three bones of one, as in hands of others' making.
HandModel tangled_hand() {
  HandModel hand = test::coarse_hand();
  for (std::size_t i = 0; i < hand.links.size(); i += 5) {
    hand.links[i] = {{0, 4, 7, 0}, {0.3, 0.4, 0.3, 0.0}};
  }
  for (std::size_t i = 1; i < hand.links.size(); i += 9) {
    hand.links[i] = {{12, 11, 10, 0}, {0.2, 0.4, 0.3, 0.1}};
  }
  return hand;
}

// Every vertex with a plane a few millimetres off and a weight.
std::vector<SurfacePair> some_pairs(const HandModel& hand, const HandPose& pose) {
  Random random(1);
  const auto some_way = [&] {
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  };
  const PosedHand posed(hand, pose);
  std::vector<SurfacePair> pairs;
  for (std::uint32_t i = 0; i < posed.vertices().size(); ++i) {
    pairs.push_back({i, posed.vertices()[i] + 0.004 * some_way(),
                     (posed.normals()[i] + 0.3 * some_way()).normalized(),
                     random.uniform(0.1, 2.0)});
  }
  return pairs;
}

// Residual by residual, in double precision.
FrameEquations plain_equations(const HandModel& hand, const HandPose& pose,
                               std::span<const SurfacePair> pairs) {
  const PosedHand posed(hand, pose);
  FrameEquations equations;
  for (const SurfacePair& pair : pairs) {
    HandRow row;
    add_vertex_row(posed, pair.vertex, pair.normal, row);
    const double residual = pair.normal.dot(posed.vertices()[pair.vertex] - pair.point);
    equations.add(residual, row, pair.weight, 0.5 * pair.weight * residual * residual);
  }
  return equations;
}

FrameEquations equations_of(const HandModel& hand, const HandPose& pose,
                            std::span<const SurfacePair> pairs,
                            InstructionSet set = best_instruction_set()) {
  SkinMotion motion(hand);
  motion.move_to(pose);
  FrameEquations equations;
  equations.cost = SurfacePairs(SkinRows(hand), pairs).add_to(equations, motion, set);
  return equations;
}

void expect_near(const FrameEquations& found, const FrameEquations& plain) {
  constexpr double kSingle = 2e-6;
  // Each number next to what it would be if all of its terms had one sign.
  const ParameterVector size = plain.hessian.diagonal().cwiseSqrt();
  const ParameterMatrix off = (found.hessian - plain.hessian).triangularView<Eigen::Lower>();
  EXPECT_LT(off.cwiseQuotient(size * size.transpose()).cwiseAbs().maxCoeff(), kSingle);
  EXPECT_LT((found.gradient - plain.gradient).cwiseQuotient(size).cwiseAbs().maxCoeff(),
            kSingle * std::sqrt(2.0 * plain.cost));
  EXPECT_NEAR(found.cost, plain.cost, 1e-5 * plain.cost);
}

TEST(SurfacePairs, GiveThePlainEquations) {
  for (const HandModel& hand : {test::coarse_hand(), tangled_hand(), mirrored(tangled_hand())}) {
    const auto pairs = some_pairs(hand, test::grasping_pose(0.2));
    for (const double turn : {0.2, 0.5}) {
      const HandPose pose = test::grasping_pose(turn);
      expect_near(equations_of(hand, pose, pairs), plain_equations(hand, pose, pairs));
    }
  }
}

TEST(SurfacePairs, GiveThePlainEquationsWhereMostJointsHaveNone) {
  const HandModel hand = test::coarse_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const auto all = some_pairs(hand, pose);
  for (std::size_t first = 0; first < all.size(); first += 40) {
    const auto few = std::span(all).subspan(first, std::min<std::size_t>(30, all.size() - first));
    const FrameEquations plain = plain_equations(hand, pose, few);
    const FrameEquations found = equations_of(hand, pose, few);
    const ParameterMatrix off = (found.hessian - plain.hessian).triangularView<Eigen::Lower>();
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 2e-6 * plain.hessian.diagonal().maxCoeff()) << first;
    EXPECT_LT((found.gradient - plain.gradient).norm(), 1e-5 * plain.gradient.norm()) << first;
  }
}

TEST(SurfacePairs, EveryInstructionSetGivesTheSameBits) {
  const HandModel hand = tangled_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const auto pairs = some_pairs(hand, pose);
  const FrameEquations baseline = equations_of(hand, pose, pairs, InstructionSet::baseline);
  for (const InstructionSet set : kInstructionSets) {
    if (!is_supported(set)) continue;
    const FrameEquations equations = equations_of(hand, pose, pairs, set);
    EXPECT_EQ(equations.hessian, baseline.hessian) << instruction_set_name(set);
    EXPECT_EQ(equations.gradient, baseline.gradient) << instruction_set_name(set);
    EXPECT_EQ(equations.cost, baseline.cost) << instruction_set_name(set);
  }
}

TEST(SurfacePairs, GradientIsThatOfTheCost) {
  const HandModel hand = tangled_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const auto pairs = some_pairs(hand, pose);
  const Eigen::MatrixXd gradient = finite_difference_jacobian(
      [&](const Eigen::VectorXd& step) {
        return Eigen::VectorXd::Constant(1, equations_of(hand, advanced(pose, step), pairs).cost);
      },
      Eigen::VectorXd::Zero(kHandParameterCount), 1e-3);
  const ParameterVector found = equations_of(hand, pose, pairs).gradient;
  EXPECT_LT((gradient.transpose() - found).norm(), 1e-3 * found.norm());
}

// Of one pair with weight 1, the gradient over the residual is the residual's row.
TEST(SurfacePairs, RowIsTheJacobian) {
  const HandModel hand = tangled_hand();
  const HandPose pose = test::grasping_pose(0.2);
  std::vector<SurfacePair> pairs = some_pairs(hand, pose);
  for (std::size_t i = 0; i < pairs.size(); i += 97) {
    SurfacePair& pair = pairs[i];
    pair.weight = 1.0;
    pair.point -= 0.1 * pair.normal;
    const std::span<const SurfacePair> one(&pair, 1);
    const Eigen::MatrixXd jacobian = finite_difference_jacobian(
        [&](const Eigen::VectorXd& step) {
          const PosedHand posed(hand, advanced(pose, step));
          return Eigen::VectorXd::Constant(
              1, pair.normal.dot(posed.vertices()[pair.vertex] - pair.point));
        },
        Eigen::VectorXd::Zero(kHandParameterCount));
    const FrameEquations equations = equations_of(hand, pose, one);
    const double residual = std::sqrt(2.0 * equations.cost);  // the point is below the surface
    EXPECT_LT((equations.gradient.transpose() / residual - jacobian).norm(), 1e-6) << i;
  }
}

TEST(SurfacePairs, FarFromTheWorldsOriginLoseNothing) {
  const HandModel& hand = test::coarse_hand();
  HandPose pose = test::grasping_pose(0.2);
  pose.world_from_hand.translation += Eigen::Vector3d(500.0, -300.0, 800.0);
  const auto pairs = some_pairs(hand, pose);
  expect_near(equations_of(hand, pose, pairs), plain_equations(hand, pose, pairs));
}

TEST(SurfacePairs, NoneAddNothing) {
  const FrameEquations equations = equations_of(tangled_hand(), test::grasping_pose(0.2), {});
  EXPECT_TRUE(equations.hessian.isZero(0.0));
  EXPECT_TRUE(equations.gradient.isZero(0.0));
  EXPECT_EQ(equations.cost, 0.0);
}

}  // namespace
}  // namespace tegata
