// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/write_video.h"

#include <gtest/gtest.h>

#include "tegata/take/test_folder.h"
#include "tegata/take/video_file.h"

namespace tegata {
namespace {

/// A gray that says which picture it is, red on the left.
CameraImage numbered(std::size_t i) {
  CameraImage picture{Image<std::uint16_t>(64, 48, static_cast<std::uint16_t>(40 + 20 * i), 3), 8};
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 24; ++x) {
      picture.values(x, y, 0) = 220;
      picture.values(x, y, 1) = picture.values(x, y, 2) = 30;
    }
  }
  return picture;
}

TEST(WriteVideo, IsReadBackPictureByPictureWithRedOnTheLeft) {
  const TestFolder folder;
  write_video(folder / "a.mp4", 30.0, 8, numbered);
  VideoFile video(folder / "a.mp4");
  ASSERT_EQ(video.frame_count(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& values = video.read(i).values;
    ASSERT_EQ(values.width(), 64);
    ASSERT_EQ(values.height(), 48);
    EXPECT_NEAR(values(50, 24, 1), 40.0 + 20.0 * static_cast<double>(i), 8.0) << i;
    EXPECT_GT(values(8, 24, 0), values(8, 24, 2) + 100) << i;
  }
}

TEST(WriteVideo, WhatCannotBeWrittenIsSaid) {
  const TestFolder folder;
  const auto odd = [](std::size_t) { return CameraImage{Image<std::uint16_t>(63, 48, 0, 3), 8}; };
  EXPECT_TRUE(
      says(error_of([&] { write_video(folder / "a.mp4", 30.0, 1, odd); }), "a.mp4", "63x48"));
  const auto growing = [](std::size_t i) {
    return CameraImage{Image<std::uint16_t>(64, i == 0 ? 48 : 50, 0, 3), 8};
  };
  EXPECT_TRUE(says(error_of([&] { write_video(folder / "a.mp4", 30.0, 2, growing); }), "a.mp4",
                   "picture 1"));
  EXPECT_TRUE(says(error_of([&] { write_video(folder / "absent/a.mp4", 30.0, 1, numbered); }),
                   "absent/a.mp4", "cannot be written"));
}

}  // namespace
}  // namespace tegata
