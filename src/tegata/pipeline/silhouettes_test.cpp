// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/silhouettes.h"

#include <gtest/gtest.h>

#include "tegata/pipeline/test_take.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

CameraImage plain(int channels, std::uint16_t value) {
  return {Image<std::uint16_t>(200, 160, value, channels), 8};
}

// One frame a camera and, where given, a picture of the empty scene.
void write_take(const TestFolder& folder, const CameraImage& picture, const CameraImage* empty) {
  write_calibration(test::small_rig(), folder / "calibration.toml");
  for (const Camera& camera : test::small_rig()) {
    std::filesystem::create_directories(folder / "images" / camera.name);
    write_picture(picture, folder / "images" / camera.name / "000000.png");
    if (empty != nullptr) {
      std::filesystem::create_directories(folder / "background");
      write_picture(*empty, folder / "background" / (camera.name + ".png"));
    }
  }
}

TEST(Silhouettes, MethodFollowsThePictures) {
  const CameraImage grey = plain(1, 100);
  const CameraImage grey_in_colour = plain(3, 100);
  CameraImage colour = plain(3, 100);
  colour.values(50, 50, 0) = 200;
  const auto chosen = [](const CameraImage& picture, const CameraImage* empty) {
    const TestFolder folder;
    write_take(folder, picture, empty);
    Take take = Take::open(folder.path());
    return choose_segmentation(take, {});
  };
  EXPECT_EQ(chosen(grey, nullptr), SegmentationMethod::infrared);
  EXPECT_EQ(chosen(grey_in_colour, nullptr), SegmentationMethod::infrared);
  EXPECT_EQ(chosen(colour, nullptr), SegmentationMethod::skin);
  EXPECT_EQ(chosen(colour, &colour), SegmentationMethod::background);
}

TEST(Silhouettes, MasksAreTakenAsTheyAre) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 2);
  Take take = Take::open(folder.path());
  EXPECT_EQ(choose_segmentation(take, {}), SegmentationMethod::mask);
  const TakeFrame frame = take.read_frame(1, {});
  const auto silhouettes = Segmenter(take, {}, {}).segment(frame);
  ASSERT_TRUE(silhouettes[0].has_value());
  EXPECT_EQ(*silhouettes[0], test::small_silhouette(1, 0));
  EXPECT_FALSE(silhouettes[2].has_value()) << "the last camera lacks the last frame";
}

TEST(Silhouettes, BackgroundWithoutItsPictureNamesTheFile) {
  const TestFolder folder;
  write_take(folder, plain(1, 100), nullptr);
  Take take = Take::open(folder.path());
  EXPECT_TRUE(says(error_of([&] { Segmenter(take, SegmentationMethod::background, {}); }),
                   "camera_0", "background", "empty scene"));
}

}  // namespace
}  // namespace tegata
