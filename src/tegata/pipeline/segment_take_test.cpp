// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/segment_take.h"

#include <gtest/gtest.h>

#include "tegata/pipeline/silhouettes.h"
#include "tegata/pipeline/test_take.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

// Warm hands before a colder room, and the last camera's last picture shows none.
void write_warm_take(const std::filesystem::path& folder, std::size_t frame_count) {
  std::filesystem::create_directories(folder);
  CameraRig rig = test::small_rig();
  for (Camera& camera : rig) camera.camera_from_world.translation *= 1000.0;
  write_calibration(rig, folder / "calibration.toml");
  write_file(folder / "take.toml",
             "fps = 20.0\nmetres_per_unit = 0.001\n[initial_pose]\nwrist = [0, 0, 0]\n"
             "index_mcp = [0, 0.1, 0]\nlittle_mcp = [0.1, 0.1, 0]\n");
  for (std::size_t c = 0; c < rig.size(); ++c) {
    const std::filesystem::path images = folder / "images" / rig[c].name;
    std::filesystem::create_directories(images);
    for (std::size_t f = 0; f < frame_count; ++f) {
      const Silhouette hand = test::small_silhouette(f, c);
      CameraImage picture{Image<std::uint16_t>(hand.width(), hand.height(), 60), 8};
      const bool is_empty = c + 1 == rig.size() && f + 1 == frame_count;
      for (std::size_t i = 0; i < hand.values().size() && !is_empty; ++i) {
        if (hand.values()[i] == PixelLabel::hand) picture.values.values()[i] = 180;
      }
      write_picture(picture, images / text("00000", f, ".png"));
    }
  }
}

TEST(SegmentTake, MakesATakeOfMasksThatIsReadAsTheFirst) {
  const TestFolder folder;
  std::filesystem::create_directories(folder / "masks_take");
  write_warm_take(folder / "take", 3);
  Take take = Take::open(folder / "take");
  SegmentTakeOptions options;
  options.frames = {0, std::nullopt, 2};
  std::vector<std::string> warnings;
  Observer observer;
  observer.on_warning = [&](std::string_view warning) { warnings.emplace_back(warning); };
  const SegmentedTake segmented = segment_take(take, folder / "masks_take", options, observer);
  EXPECT_EQ(segmented.method, SegmentationMethod::infrared);

  Take masks = Take::open(folder / "masks_take");
  EXPECT_EQ(masks.source(), PictureSource::masks);
  EXPECT_EQ(masks.frame_names(), (std::vector<std::string>{"000000", "000002"}));
  EXPECT_EQ(masks.info().fps, 10.0) << "every other frame";
  EXPECT_TRUE(masks.info().initial_landmarks.has_value());
  EXPECT_TRUE(masks.rig()[1].camera_from_world.translation.isApprox(
      take.rig()[1].camera_from_world.translation));
  const auto before = Segmenter(take, {}, {}).segment(take.read_frame(2, {}));
  const auto after = Segmenter(masks, {}, {}).segment(masks.read_frame(1, {}));
  for (std::size_t c = 0; c < before.size(); ++c) EXPECT_EQ(*before[c], *after[c]) << c;

  ASSERT_EQ(segmented.frames.size(), 2u);
  ASSERT_EQ(segmented.frames[1].views.size(), 3u);
  EXPECT_GT(segmented.frames[1].views[0].confidence, 0.9);
  EXPECT_EQ(segmented.frames[1].views[2].hand_pixels, 0u);
  EXPECT_EQ(segmented.frames[1].views[2].confidence, 0.0);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(says(warnings[0], "000002", "camera_2", "no hand"));
}

TEST(SegmentTake, TheContactSheetShowsEveryCameraAndDimsTheRoom) {
  const TestFolder folder;
  std::filesystem::create_directories(folder / "masks_take");
  write_warm_take(folder / "take", 2);
  Take take = Take::open(folder / "take");
  const CameraImage sheet = segment_take(take, folder / "masks_take", {}, {}).contact_sheet;
  EXPECT_GE(sheet.values.width(), 3 * 200);
  EXPECT_GE(sheet.values.height(), 2 * 160);
  std::size_t bright = 0;
  for (const std::uint16_t value : sheet.values.values()) bright += value > 200 ? 1 : 0;
  EXPECT_GT(bright, 1000u) << "the hands";
  EXPECT_LT(bright, sheet.values.values().size() / 2) << "the room";
}

}  // namespace
}  // namespace tegata
