// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/take.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/test_video.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 40, kHeight = 30;

CameraImage gray_picture(int gray, int width = kWidth) {
  return {Image<std::uint16_t>(width, kHeight, static_cast<std::uint16_t>(gray)), 8};
}

// A take of the cameras left and right; tests put in what they need.
class TakeTest : public testing::Test {
 protected:
  TakeTest() {
    fs::create_directories(take_);
    CameraRig rig(2);
    for (Camera& camera : rig) {
      camera.name = &camera == &rig[0] ? "left" : "right";
      camera.width = kWidth;
      camera.height = kHeight;
      camera.fx = camera.fy = 50.0;
      camera.camera_from_world.translation = {0.0, 0.0, 200.0};
    }
    write_calibration(rig, take_ / "calibration.toml");
  }

  void put(const fs::path& name, const CameraImage& picture) {
    fs::create_directories((take_ / name).parent_path());
    write_picture(picture, take_ / name);
  }
  void put_two(const std::string& source, const std::string& frame, int gray) {
    put(source + "/left/" + frame, gray_picture(gray));
    put(source + "/right/" + frame, gray_picture(gray));
  }
  void put_info(const std::string& content) { write_file(take_ / "take.toml", content); }
  void put_video(const std::string& camera, std::size_t count) {
    fs::create_directories(take_ / "videos");
    const std::vector<CameraImage> pictures(
        count, CameraImage{Image<std::uint16_t>(kWidth, kHeight, 90, 3), 8});
    write_file(take_ / "videos" / (camera + ".avi"), motion_jpeg_avi(pictures));
  }
  std::string open_error() {
    return error_of([&] { Take::open(take_); });
  }
  Observer observer() {
    return {{}, [this](std::string_view message) { warnings_.emplace_back(message); }};
  }

  TestFolder folder_;
  fs::path take_ = folder_ / "mug-03";
  std::vector<std::string> warnings_;
};

TEST_F(TakeTest, FramesAreInNaturalOrderWithTheirTimes) {
  for (const char* name : {"f10.png", "f9.png", "f2.jpg"}) put_two("images", name, 100);
  put_info("fps = 10\nmetres_per_unit = 0.01\n");
  Take take = Take::open(take_);
  EXPECT_EQ(take.frame_names(), (std::vector<std::string>{"f2", "f9", "f10"}));
  EXPECT_EQ(take.info().name, "mug-03");
  EXPECT_EQ(take.source(), PictureSource::images);
  EXPECT_NEAR(take.rig()[0].camera_from_world.translation.z(), 2.0, 1e-12);
  const TakeFrame frame = take.read_frame(2, observer());
  EXPECT_EQ(frame.name, "f10");
  EXPECT_DOUBLE_EQ(frame.time, 0.2);
  EXPECT_EQ(frame.view_count(), 2u);
  EXPECT_EQ(frame.pictures[1]->values(3, 4), 100);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(TakeTest, AFrameThatACameraLacksKeepsTheOthers) {
  put_two("images", "0.png", 1);
  put("images/right/1.png", gray_picture(7));
  Take take = Take::open(take_);
  const TakeFrame frame = take.read_frame(1, observer());
  EXPECT_EQ(frame.view_count(), 1u);
  EXPECT_FALSE(frame.pictures[0].has_value());
  EXPECT_EQ(frame.pictures[1]->values(0, 0), 7);
}

TEST_F(TakeTest, ATruncatedPictureIsLeftOutAndSaidOnce) {
  put_two("images", "0.png", 1);
  put_two("images", "1.png", 2);
  const std::string bytes = read_file(take_ / "images/left/1.png");
  write_file(take_ / "images/left/1.png", bytes.substr(0, bytes.size() / 2));
  Take take = Take::open(take_);
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(take.read_frame(1, observer()).view_count(), 1u);
  }
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(says(warnings_[0], "frame 1", "'left'", "1.png", "cut short"));
}

TEST_F(TakeTest, ALaterPictureOfAnotherSizeIsLeftOutAndSaid) {
  put_two("images", "0.png", 1);
  put_two("images", "1.png", 2);
  put("images/right/1.png", gray_picture(2, kWidth + 1));
  Take take = Take::open(take_);
  EXPECT_FALSE(take.read_frame(1, observer()).pictures[1].has_value());
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(says(warnings_[0], "'right'", "41 x 30", "40 x 30"));
}

TEST_F(TakeTest, AFirstPictureOfAnotherSizeIsAnError) {
  put_two("images", "0.png", 1);
  put("images/right/0.png", gray_picture(2, kWidth + 1));
  EXPECT_TRUE(says(open_error(), "'right'", "41 x 30", "40 x 30"));
}

TEST_F(TakeTest, WhatIsMissingIsSaid) {
  EXPECT_TRUE(says(open_error(), "mug-03", "images/", "videos/", "masks/"));
  put("images/left/0.png", gray_picture(1));
  EXPECT_TRUE(says(open_error(), "'right'", "images/right/<frame>.png"));
  put("images/right/1.png", gray_picture(1));
  EXPECT_TRUE(says(open_error(), "no frame", "two cameras"));
  fs::remove(take_ / "calibration.toml");
  EXPECT_TRUE(says(open_error(), "calibration.toml", "[cam_0]"));
  EXPECT_TRUE(says(error_of([&] { Take::open(take_ / "no"); }), "no such folder", "take"));
}

TEST_F(TakeTest, ImagesBesideVideosAreAmbiguous) {
  put_two("images", "0.png", 1);
  put_video("left", 1);
  EXPECT_TRUE(says(open_error(), "images/", "videos/"));
}

TEST_F(TakeTest, TwoFilesOfOneFrameAreAmbiguous) {
  put_two("images", "0.png", 1);
  put("images/left/0.jpg", gray_picture(1));
  EXPECT_TRUE(says(open_error(), "0.png", "0.jpg"));
}

TEST_F(TakeTest, AFolderOfNoCameraIsANoteThatTheFirstFrameSays) {
  put_two("images", "0.png", 1);
  put("images/top/0.png", gray_picture(1));
  Take take = Take::open(take_);
  take.read_frame(0, observer());
  take.read_frame(0, observer());
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(says(warnings_[0], "top", "left, right"));
  EXPECT_EQ(take.notes(), warnings_);
}

TEST_F(TakeTest, MasksAreUsedInsteadOfPicturesWhichStayVisible) {
  put_two("images", "0.png", 33);
  put_two("images", "1.png", 34);
  put_two("masks", "1.png", 250);
  put_two("masks", "2.jpg", 130);
  Take take = Take::open(take_);
  EXPECT_EQ(take.source(), PictureSource::masks);
  EXPECT_TRUE(take.has_pictures());
  EXPECT_EQ(take.frame_names(), (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(take.read_frame(0, observer()).pictures[0]->values(0, 0), 255);
  EXPECT_EQ(take.read_display_frame(0, observer()).pictures[0]->values(0, 0), 34);
  EXPECT_EQ(take.read_display_frame(1, observer()).pictures[0]->values(0, 0), 128);
}

TEST_F(TakeTest, MasksAloneWillDo) {
  put_two("masks", "0.png", 255);
  put_info("[segmentation]\nmethod = \"mask\"\n");
  Take take = Take::open(take_);
  EXPECT_FALSE(take.has_pictures());
  EXPECT_EQ(take.read_display_frame(0, observer()).pictures[0]->values(0, 0), 255);
}

TEST_F(TakeTest, MethodsThatLackTheirFilesAreErrors) {
  put_two("images", "0.png", 1);
  put_info("[segmentation]\nmethod = \"mask\"\n");
  EXPECT_TRUE(says(open_error(), "take.toml", "'method'", "masks/"));
  put_info("[segmentation]\nmethod = \"background\"\n");
  EXPECT_TRUE(says(open_error(), "'method'", "background/left.png"));
}

TEST_F(TakeTest, TheEmptySceneIsFoundByCameraAndChecked) {
  put_two("images", "0.png", 1);
  put("background/right.png", gray_picture(9));
  const Take take = Take::open(take_);
  EXPECT_FALSE(take.background(0).has_value());
  EXPECT_EQ(take.background(1)->values(1, 1), 9);
  put("background/left.png", gray_picture(9, kWidth - 1));
  EXPECT_TRUE(says(error_of([&] { take.background(0); }), "left.png", "39 x 30", "40 x 30"));
}

TEST_F(TakeTest, VideosPairUpByIndexAndTheLongestCounts) {
  put_video("left", 3);
  put_video("right", 5);
  put_video("top", 1);
  Take take = Take::open(take_);
  EXPECT_EQ(take.source(), PictureSource::videos);
  ASSERT_EQ(take.frame_names().size(), 5u);
  EXPECT_EQ(take.frame_names()[4], "000004");
  EXPECT_EQ(take.notes().size(), 1u);
  EXPECT_EQ(take.read_frame(2, observer()).view_count(), 2u);
  EXPECT_EQ(take.read_frame(4, observer()).view_count(), 1u);
  fs::remove(take_ / "videos/left.avi");
  EXPECT_TRUE(says(open_error(), "'left'", "videos/left.mp4"));
}

TEST_F(TakeTest, ACameraThatStartedEarlierIsReadLater) {
  for (int f = 0; f < 6; ++f) put_two("images", text(f, ".png"), 10 * f);
  put_info("[offset]\nright = 2\n");
  Take take = Take::open(take_);
  ASSERT_EQ(take.frame_names().size(), 6u);
  const TakeFrame first = take.read_frame(0, observer()), last = take.read_frame(4, observer());
  EXPECT_EQ(first.pictures[0]->values(0, 0), 0);
  EXPECT_EQ(first.pictures[1]->values(0, 0), 20);
  EXPECT_EQ(last.pictures[0]->values(0, 0), 40);
  EXPECT_FALSE(last.pictures[1].has_value());

  put_info("[offset]\nright = -1\n");
  Take later = Take::open(take_);
  EXPECT_EQ(later.read_frame(0, observer()).view_count(), 1u);
  EXPECT_EQ(later.read_frame(5, observer()).pictures[1]->values(0, 0), 40);

  put_info("[offset]\nright = 1\nleft = 3\n");
  Take both = Take::open(take_);
  EXPECT_EQ(both.frame_names().size(), 5u);  // nobody has a sixth
  EXPECT_EQ(both.read_frame(1, observer()).pictures[0]->values(0, 0), 40);
  EXPECT_EQ(both.read_frame(1, observer()).pictures[1]->values(0, 0), 20);
}

TEST_F(TakeTest, OffsetsHoldForVideosAndMasksAsWell) {
  put_video("left", 6);
  put_video("right", 4);
  put_info("[offset]\nleft = 3\n");
  EXPECT_EQ(Take::open(take_).frame_names().size(), 4u);
  EXPECT_EQ(Take::open(take_).read_frame(3, observer()).view_count(), 1u);
  for (int f = 0; f < 6; ++f) put_two("masks", text("00000", f, ".png"), f < 4 ? 0 : 255);
  Take take = Take::open(take_);
  const TakeFrame frame = take.read_frame(2, observer());
  EXPECT_EQ(frame.pictures[0]->values(0, 0), 255);
  EXPECT_EQ(frame.pictures[1]->values(0, 0), 0);
}

TEST_F(TakeTest, OffsetsOfCamerasThatAreNotThereAndBeyondTheRecordingAreErrors) {
  put_two("images", "0.png", 1);
  put_info("[offset]\ntop = 1\n");
  EXPECT_TRUE(says(open_error(), "[offset]", "'top'", "'left', 'right'"));
  put_info("[offset]\nleft = 5\n");
  EXPECT_TRUE(says(open_error(), "no frame has pictures of two cameras"));
}

TEST_F(TakeTest, LabelImagesShowTheHandByItsNumber) {
  CameraImage labels = gray_picture(0);
  labels.values(1, 0) = 7;
  labels.values(2, 0) = 254;
  labels.values(3, 0) = 255;
  put("masks/left/0.png", labels);
  put("masks/right/0.png", labels);
  put_info("[segmentation]\nhand_label = 7\n");
  Take take = Take::open(take_);
  const Image<std::uint16_t> mask = take.read_frame(0, observer()).pictures[1]->values;
  EXPECT_EQ(mask(0, 0), 0);
  EXPECT_EQ(mask(1, 0), 255);
  EXPECT_EQ(mask(2, 0), 128);
  EXPECT_EQ(mask(3, 0), 128);
  put("masks/left/0.png", CameraImage{[] {
                                        Image<std::uint16_t> colour(kWidth, kHeight, 7, 3);
                                        colour(4, 5, 1) = 9;
                                        return colour;
                                      }(),
                                      8});
  EXPECT_FALSE(Take::open(take_).read_frame(0, observer()).pictures[0].has_value());
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(says(warnings_[0], "label image in colour", "4, 5"));
}

TEST_F(TakeTest, HandLabelsWithoutMasksAreErrors) {
  put_two("images", "0.png", 1);
  put_info("[segmentation]\nhand_label = 7\n");
  EXPECT_TRUE(says(open_error(), "'hand_label'", "masks/"));
}

TEST_F(TakeTest, IndicesPastTheEndAreErrors) {
  put_two("images", "0.png", 1);
  Take take = Take::open(take_);
  EXPECT_TRUE(says(error_of([&] { take.read_frame(1, observer()); }), "index 1", "below 1"));
}

}  // namespace
}  // namespace tegata
