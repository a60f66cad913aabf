// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/view.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"

namespace tegata {
namespace {

Camera small_camera() {
  Camera camera;
  camera.name = "left";
  camera.width = 40;
  camera.height = 30;
  camera.fx = camera.fy = 50.0;
  return camera;
}

TEST(FitView, DistancesPartWhereABorderIsUnknown) {
  Silhouette silhouette(40, 30, PixelLabel::background);
  for (int y = 5; y < 25; ++y) {
    for (int x = 5; x < 35; ++x) silhouette(x, y) = x < 20 ? PixelLabel::hand : PixelLabel::unknown;
  }
  const FitView view = make_fit_view(small_camera(), silhouette);
  EXPECT_FLOAT_EQ((*view.hand_distance)(6, 15), (*view.possible_distance)(6, 15));
  EXPECT_LT((*view.hand_distance)(18, 15) + 3.0F, (*view.possible_distance)(18, 15));
}

TEST(FitView, RefusesAnotherSizeAndADistortedCamera) {
  EXPECT_THROW(make_fit_view(small_camera(), Silhouette(30, 30)), Error);
  Camera distorted = small_camera();
  distorted.distortion[0] = 0.1;
  EXPECT_THROW(make_fit_view(distorted, Silhouette(40, 30)), Error);
}

}  // namespace
}  // namespace tegata
