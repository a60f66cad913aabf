// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/stored_view.h"

#include <gtest/gtest.h>

#include "tegata/base/random.h"
#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

TEST(StoredView, IsRestoredToTheLastPixel) {
  const Camera camera = test::orthogonal_rig(0.8).front();
  Silhouette silhouette(camera.width, camera.height);
  Random random(3);
  constexpr PixelLabel kLabels[] = {PixelLabel::background, PixelLabel::unknown, PixelLabel::hand};
  for (std::size_t i = 0; i < silhouette.pixel_count();) {
    const PixelLabel label = kLabels[static_cast<std::size_t>(2.999 * random.uniform())];
    const auto end = i + static_cast<std::size_t>(1.0 + 900.0 * random.uniform());
    for (; i < std::min(end, silhouette.pixel_count()); ++i) silhouette.values()[i] = label;
  }
  const FitView view = make_fit_view(camera, silhouette);
  const FitView restored = StoredView(view).restored();
  EXPECT_EQ(restored.camera.name, camera.name);
  EXPECT_EQ(restored.silhouette, silhouette);
  EXPECT_EQ(*restored.hand_distance, *view.hand_distance);
  EXPECT_EQ(*restored.possible_distance, *view.possible_distance);
  ASSERT_EQ(restored.contour.size(), view.contour.size());
  for (std::size_t i = 0; i < view.contour.size(); ++i) {
    EXPECT_EQ(restored.contour[i].pixel, view.contour[i].pixel);
  }
}

}  // namespace
}  // namespace tegata
