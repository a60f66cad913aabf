// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/outline.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"
#include "tegata/image/distance_transform.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

TEST(Outline, LiesOnTheBorderOfTheDrawnHand) {
  const HandModel& hand = test::coarse_hand();
  const PosedHand posed(hand, test::grasping_pose(0.2));
  for (const Camera& camera : test::orthogonal_rig(0.8)) {
    const auto outline = hand_outline(FitHand(hand), posed, camera);
    const Image<float> distance =
        signed_distance(render_silhouette(posed.surface(), camera),
                        [](PixelLabel label) { return label == PixelLabel::hand; });
    ASSERT_GT(outline.size(), 100U);
    double sum = 0.0;
    for (const OutlinePoint& point : outline) {
      const double off = sample_bilinear(distance, point.pixel.x(), point.pixel.y());
      EXPECT_LT(std::abs(off), 2.5);
      sum += std::abs(off);
    }
    EXPECT_LT(sum / static_cast<double>(outline.size()), 0.5);
  }
}

TEST(Outline, RowIsTheFiniteDifferenceOfThePointOnTheSurface) {
  const HandModel& hand = test::coarse_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const PosedHand posed(hand, pose);
  const Eigen::RowVector3d along(0.3, -0.5, 0.8);
  const auto outline = hand_outline(FitHand(hand), posed, test::orthogonal_rig(0.8)[0]);
  for (std::size_t i = 0; i < outline.size(); i += 37) {
    const OutlinePoint& point = outline[i];
    const auto position = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
      const PosedHand moved(hand, advanced(pose, step));
      return along * ((1.0 - point.fraction) * moved.vertices()[point.a] +
                      point.fraction * moved.vertices()[point.b]);
    };
    const Eigen::MatrixXd expected = finite_difference_jacobian(position, ParameterVector::Zero());
    EXPECT_LT((outline_row(posed, point, along).values - expected).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace tegata
