// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_row.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

void expect_rows_of_jacobians(const HandModel& hand) {
  const PosedHand posed(hand, test::grasping_pose(0.2));
  const Eigen::Vector3d along(0.3, -0.5, 0.8);
  for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
    HandRow row;
    add_vertex_row(posed, i, along, row);
    const ParameterRow expected = along.transpose() * posed.vertex_jacobian(i);
    ASSERT_LT((row.values - expected).norm(), 1e-12) << "vertex " << i;
    for (int digit = 0; digit < kDigitCount; ++digit) {
      if ((row.digits >> digit & 1U) == 0) {
        ASSERT_TRUE(expected.segment<kAnglesPerDigit>(kPoseParameterCount + kAnglesPerDigit * digit)
                        .isZero(0.0))
            << "vertex " << i << ", digit " << digit;
      }
    }
  }
}

TEST(SurfaceRow, IsARowOfTheJacobian) { expect_rows_of_jacobians(test::coarse_hand()); }

TEST(SurfaceRow, OfAVertexThatTwoDigitsMoveHasBoth) {
  HandModel hand = test::coarse_hand();
  // Palm, index and middle finger.
  for (std::size_t i = 0; i < hand.links.size(); i += 3) {
    hand.links[i] = {{0, 4, 7, 0}, {0.3, 0.4, 0.3, 0.0}};
  }
  expect_rows_of_jacobians(hand);
}

}  // namespace
}  // namespace tegata
