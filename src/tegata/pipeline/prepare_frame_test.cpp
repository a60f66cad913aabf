// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/prepare_frame.h"

#include <gtest/gtest.h>

#include "tegata/pipeline/test_take.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

TEST(PrepareFrame, AViewWithoutAHandIsLeftOutAndNoted) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 2);
  write_picture({Image<std::uint16_t>(200, 160, 0), 8}, folder / "masks/camera_1/000000.png");
  Take take = Take::open(folder.path());
  const PreparedFrame prepared = prepare_frame(Segmenter(take, {}, {}), take.read_frame(0, {}), {});
  EXPECT_EQ(prepared.refusal, "");
  EXPECT_EQ(prepared.frame.views.size(), 2U);
  ASSERT_EQ(prepared.notes.size(), 1U);
  EXPECT_TRUE(says(prepared.notes[0], "000000", "camera_1"));
}

TEST(PrepareFrame, TheHullHoldsTheHand) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 2);
  Take take = Take::open(folder.path());
  const PreparedFrame prepared = prepare_frame(Segmenter(take, {}, {}), take.read_frame(0, {}), {});
  ASSERT_TRUE(prepared.frame.hull.has_value());
  const double hand_volume =
      enclosed_volume(PosedHand(test::small_hand(), test::small_pose(0)).surface());
  EXPECT_GT(enclosed_volume(prepared.hull), 0.95 * hand_volume);
  EXPECT_LT(enclosed_volume(prepared.hull), 2.5 * hand_volume);
}

TEST(PrepareFrame, OfFourViewsTheOneThatEmptiesTheHullIsLeftOutAndNamed) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 2);
  Take take = Take::open(folder.path());
  PreparedFrame prepared = prepare_views(Segmenter(take, {}, {}), take.read_frame(0, {}));
  FitView elsewhere = prepared.frame.views[0];
  elsewhere.camera.name = "pushed";
  elsewhere.silhouette = Silhouette(200, 160, PixelLabel::background);
  for (int i = 0; i < 8; ++i) elsewhere.silhouette(i, i) = PixelLabel::hand;
  prepared.frame.views.push_back(elsewhere);
  add_hull(prepared, {});
  EXPECT_EQ(prepared.refusal, "");
  EXPECT_TRUE(prepared.frame.hull.has_value());
  EXPECT_EQ(prepared.frame.views.size(), 3U);
  EXPECT_EQ(prepared.left_out.count("pushed"), 1U);
  EXPECT_TRUE(says(prepared.notes.back(), "pushed", "nothing in common"));
}

}  // namespace
}  // namespace tegata
