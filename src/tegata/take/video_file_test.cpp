// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/video_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tegata/base/text.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/test_video.h"

namespace tegata {
namespace {

// Pictures of one gray each: 20, 40, 60 ...
std::vector<CameraImage> steps_of_gray(std::size_t count) {
  std::vector<CameraImage> pictures;
  for (std::size_t i = 0; i < count; ++i) {
    const auto gray = static_cast<std::uint16_t>(20 * (i + 1));
    pictures.push_back({Image<std::uint16_t>(64, 48, gray, 3), 8});
  }
  return pictures;
}

TEST(VideoFile, GivesThePictureThatIsAskedForInAnyOrder) {
  const TestFolder folder;
  write_file(folder / "a.avi", motion_jpeg_avi(steps_of_gray(10)));
  VideoFile video(folder / "a.avi");
  ASSERT_EQ(video.frame_count(), 10u);
  for (const std::size_t index : {0u, 0u, 1u, 4u, 9u, 9u, 3u, 2u, 8u}) {
    const CameraImage& picture = video.read(index);
    EXPECT_EQ(picture.values.width(), 64);
    EXPECT_EQ(picture.values.channels(), 3);
    EXPECT_NEAR(picture.values(30, 20), 20.0 * static_cast<double>(index + 1), 3.0) << index;
  }
}

TEST(VideoFile, PicturesPastTheEndAreErrorsAndDoNotSpoilTheRest) {
  const TestFolder folder;
  write_file(folder / "a.avi", motion_jpeg_avi(steps_of_gray(4)));
  VideoFile video(folder / "a.avi");
  for (int again = 0; again < 2; ++again) {
    EXPECT_TRUE(says(error_of([&] { video.read(7); }), "a.avi", "picture 7", "after 4"));
    EXPECT_NEAR(video.read(3).values(5, 5), 80.0, 3.0);
  }
}

// Overwrites most of a picture, or cuts the file within it.
std::string damaged_avi(std::size_t index, bool cut) {
  std::string avi = motion_jpeg_avi(steps_of_gray(10));
  std::size_t at = 0;
  for (std::size_t i = 0; i <= index; ++i) at = avi.find("00dc", at) + 4;
  if (cut) {
    avi.resize(at + 100);
  } else {
    const std::size_t end = avi.find("00dc", at);
    std::fill(avi.begin() + static_cast<std::ptrdiff_t>(at + 40),
              avi.begin() + static_cast<std::ptrdiff_t>(end), '\0');
  }
  return avi;
}

TEST(VideoFile, ABrokenPictureCostsNoOther) {
  const TestFolder folder;
  for (const std::size_t broken : {0u, 5u}) {
    write_file(folder / "a.avi", damaged_avi(broken, false));
    VideoFile video(folder / "a.avi");
    for (const std::size_t index : {0u, 1u, 4u, 5u, 6u, 9u, 5u, 6u, 2u, 0u}) {
      if (index == broken) {
        EXPECT_TRUE(says(error_of([&] { video.read(index); }), "a.avi", text("picture ", index)));
      } else {
        EXPECT_NEAR(video.read(index).values(30, 20), 20.0 * static_cast<double>(index + 1), 3.0);
      }
    }
  }
}

// FFmpeg passes over a picture whose head is damaged, and those after it count one less.
TEST(VideoFile, PicturesAfterOneWhoseHeadIsDamagedKeepTheirNumbers) {
  const TestFolder folder;
  for (const std::size_t broken : {0u, 4u, 5u, 8u}) {
    std::string avi = motion_jpeg_avi(steps_of_gray(10));
    std::size_t at = avi.find("movi");
    for (std::size_t i = 0; i <= broken; ++i) at = avi.find("00dc", at) + 4;
    avi.replace(at - 4, 50, 50, '\0');
    write_file(folder / "a.avi", avi);
    VideoFile video(folder / "a.avi");
    EXPECT_EQ(video.frame_count(), 10u);
    for (const std::size_t index : {0u, 1u, 4u, 5u, 6u, 9u, 5u, 6u, 2u, 8u}) {
      if (index == broken) {
        EXPECT_TRUE(says(error_of([&] { video.read(index); }), "a.avi", text("picture ", index)));
      } else {
        EXPECT_NEAR(video.read(index).values(30, 20), 20.0 * static_cast<double>(index + 1), 3.0)
            << broken << " " << index;
      }
    }
  }
}

TEST(VideoFile, AVideoThatIsCutShortGivesWhatItHas) {
  const TestFolder folder;
  write_file(folder / "a.avi", damaged_avi(5, true));
  VideoFile video(folder / "a.avi");
  for (const std::size_t index : {5u, 9u, 4u, 6u, 3u}) {
    if (index >= 5) {
      EXPECT_TRUE(says(error_of([&] { video.read(index); }), "a.avi", "ends after 5"));
    } else {
      EXPECT_NEAR(video.read(index).values(30, 20), 20.0 * static_cast<double>(index + 1), 3.0);
    }
  }
}

TEST(VideoFile, AHeaderThatClaimsMillionsOfPicturesIsNotBelieved) {
  const TestFolder folder;
  std::string avi = motion_jpeg_avi(steps_of_gray(3));
  avi[avi.find("vidsMJPG") + 35] = '\x2b';  // the last byte of the count
  write_file(folder / "a.avi", avi);
  VideoFile video(folder / "a.avi");
  EXPECT_EQ(video.frame_count(), 3u);
  EXPECT_NEAR(video.read(2).values(30, 20), 60.0, 3.0);
}

TEST(VideoFile, FilesThatAreNoVideosAreSaid) {
  const TestFolder folder;
  write_file(folder / "text.avi", "this is text");
  EXPECT_TRUE(says(error_of([&] { VideoFile(folder / "text.avi"); }), "text.avi", "video"));
  EXPECT_TRUE(says(error_of([&] { VideoFile(folder / "no.avi"); }), "no.avi", "no such file"));
}

TEST(VideoFile, AnMp4WithoutItsIndexIsSaid) {
  const TestFolder folder;
  const std::string header(
      "\0\0\0\x10"
      "ftypisom\0\0\0\0",
      16);
  const std::string data(
      "\0\0\x10\0"
      "mdat",
      8);
  write_file(folder / "a.mp4", header + data + std::string(100, 'x'));
  EXPECT_TRUE(says(error_of([&] { VideoFile(folder / "a.mp4"); }), "a.mp4", "cut short"));
}

TEST(VideoFile, ReadsARecordedMp4) {
  const std::filesystem::path file = TEGATA_DATA_DIR "/hand_2cam/cam0.mp4";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the recording hand_2cam is not here";
  VideoFile video(file);
  EXPECT_EQ(video.frame_count(), 200u);
  EXPECT_EQ(video.read(3).values.width(), 720);
  const CameraImage third = video.read(3);
  video.read(5);
  EXPECT_EQ(video.read(3).values, third.values);
}

}  // namespace
}  // namespace tegata
