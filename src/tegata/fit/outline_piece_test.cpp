// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/outline_piece.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tegata/fit/test_scene.h"
#include "tegata/image/distance_transform.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

TEST(OutlinePiece, TogetherTheyAreAsLongAsTheBorderOfTheDrawnHand) {
  const HandModel& hand = test::coarse_hand();
  const PosedHand posed(hand, test::grasping_pose(0.2));
  for (const Camera& camera : test::orthogonal_rig(0.8)) {
    const Silhouette drawn = render_silhouette(posed.surface(), camera);
    const Image<float> distance =
        signed_distance(drawn, [](PixelLabel label) { return label == PixelLabel::hand; });
    double length = 0.0, off = 0.0;
    for (const OutlinePiece& piece :
         outline_pieces(FitHand(hand), posed, camera, HandPicture(posed, camera))) {
      length += piece.weight_px;
      off +=
          piece.weight_px * std::abs(sample_bilinear(distance, piece.pixel.x(), piece.pixel.y()));
    }
    EXPECT_LT(off / length, 0.4);
    // A line crosses 4 / pi borders between pixels a pixel of its length, all directions alike.
    int borders = 0;
    for (int y = 0; y + 1 < drawn.height(); ++y) {
      for (int x = 0; x + 1 < drawn.width(); ++x) {
        borders += drawn(x, y) != drawn(x + 1, y) ? 1 : 0;
        borders += drawn(x, y) != drawn(x, y + 1) ? 1 : 0;
      }
    }
    EXPECT_NEAR(length * 4.0 / 3.14159, borders, 0.15 * borders);
  }
}

TEST(OutlinePiece, RowIsTheFiniteDifferenceOfThePointOnTheSurface) {
  const HandModel& hand = test::coarse_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const PosedHand posed(hand, pose);
  const Eigen::RowVector3d along(0.3, -0.5, 0.8);
  const Camera camera = test::orthogonal_rig(0.8)[0];
  const auto pieces = outline_pieces(FitHand(hand), posed, camera, HandPicture(posed, camera));
  for (std::size_t i = 0; i < pieces.size(); i += 37) {
    const OutlinePiece& piece = pieces[i];
    const auto position = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
      const PosedHand moved(hand, advanced(pose, step));
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        point += piece.fractions[static_cast<Eigen::Index>(k)] * moved.vertices()[piece.corners[k]];
      }
      return along * point;
    };
    const Eigen::MatrixXd expected = finite_difference_jacobian(position, ParameterVector::Zero());
    EXPECT_LT((outline_row(posed, piece, along).values - expected).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace tegata
