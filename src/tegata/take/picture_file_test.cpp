// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/picture_file.h"

#include <gtest/gtest.h>

#include <string>

#include "tegata/base/random.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

CameraImage noise(int width, int height, int channels, int bits) {
  CameraImage picture{Image<std::uint16_t>(width, height, 0, channels), bits};
  Random random(7);
  for (std::uint16_t& value : picture.values.values()) {
    value = static_cast<std::uint16_t>(random.index(bits == 8 ? 256 : 65536));
  }
  return picture;
}

TEST(PictureFile, PngAndTiffGiveBackEveryValueAndTheOrderOfColours) {
  const TestFolder folder;
  for (const char* ending : {"png", "tif"}) {
    for (const int channels : {1, 3}) {
      for (const int bits : {8, 16}) {
        const CameraImage picture = noise(37, 23, channels, bits);
        const auto file = folder / (std::string("picture.") + ending);
        write_picture(picture, file);
        const CameraImage back = read_picture(file);
        EXPECT_EQ(back.bits, bits);
        EXPECT_EQ(back.values, picture.values) << ending << " " << channels << " " << bits;
      }
    }
  }
}

TEST(PictureFile, JpegKeepsRedRed) {
  const TestFolder folder;
  CameraImage picture{Image<std::uint16_t>(32, 32, 0, 3), 8};
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) picture.values(x, y, 0) = 200;
  }
  write_picture(picture, folder / "red.jpg");
  const CameraImage back = read_picture(folder / "red.jpg");
  ASSERT_EQ(back.values.channels(), 3);
  EXPECT_NEAR(back.values(16, 16, 0), 200, 5);
  EXPECT_NEAR(back.values(16, 16, 2), 0, 5);
  const auto bytes = encode_jpeg(picture, 90);
  EXPECT_EQ(bytes.at(0), 0xff);
  EXPECT_EQ(bytes.at(1), 0xd8);
}

// OpenCV decodes half a file to half a picture without a word.
TEST(PictureFile, ATruncatedFileIsNoPicture) {
  const TestFolder folder;
  for (const char* name : {"a.png", "a.jpg", "a.tif"}) {
    write_picture(noise(64, 48, 1, 8), folder / name);
    const std::string bytes = read_file(folder / name);
    for (const std::size_t size : {bytes.size() / 2, bytes.size() - 1, std::size_t{9}}) {
      write_file(folder / name, bytes.substr(0, size));
      EXPECT_TRUE(says(error_of([&] { read_picture(folder / name); }), name, "cut short")) << size;
    }
  }
}

TEST(PictureFile, ADamagedPngIsNoPicture) {
  const TestFolder folder;
  write_picture(noise(64, 48, 1, 8), folder / "a.png");
  std::string bytes = read_file(folder / "a.png");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x10);
  write_file(folder / "a.png", bytes);
  EXPECT_TRUE(says(error_of([&] { read_picture(folder / "a.png"); }), "a.png", "damaged"));
}

// Half a minute and gigabytes went into a picture of which there are some hundred bytes.
TEST(PictureFile, AHeaderThatClaimsMoreThanAnyCameraHasIsRefused) {
  const TestFolder folder;
  const std::string png(
      "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122"
      "\000\000\352\140\000\000\352\140\010\000\000\000\000\245\271\052\236",
      33);
  write_file(folder / "a.png", png);
  write_picture(noise(64, 48, 1, 8), folder / "a.jpg");
  std::string jpeg = read_file(folder / "a.jpg");
  const std::size_t frame = jpeg.find("\xff\xc0");
  jpeg.replace(frame + 5, 4, "\x60\x60\x60\x60");
  write_file(folder / "a.jpg", jpeg);
  write_picture(noise(64, 48, 1, 8), folder / "a.tif");
  std::string tiff = read_file(folder / "a.tif");
  for (const char tag : {'\0', '\1'}) {  // 256 and 257, one number of 16 bits each
    tiff.replace(tiff.find(std::string{tag, 1, 3, 0, 1, 0, 0, 0}) + 8, 2, "\x60\x60");
  }
  write_file(folder / "a.tif", tiff);
  for (const char* name : {"a.png", "a.jpg", "a.tif"}) {
    EXPECT_TRUE(says(error_of([&] { read_picture(folder / name); }), name, "expected at most"));
  }
}

TEST(PictureFile, ForeignAndMissingFilesAreSaid) {
  const TestFolder folder;
  write_file(folder / "text.png", "this is text");
  write_file(folder / "empty.png", "");
  EXPECT_TRUE(says(error_of([&] { read_picture(folder / "text.png"); }), "text.png", "PNG, JPEG"));
  EXPECT_TRUE(says(error_of([&] { read_picture(folder / "empty.png"); }), "empty.png", "empty"));
  EXPECT_TRUE(says(error_of([&] { read_picture(folder / "no.png"); }), "no.png", "No such file"));
}

// libpng prints a warning about this colour profile.
TEST(PictureFile, AFaultyColourProfileInAPngIsPassedOverInSilence) {
  const TestFolder folder;
  const CameraImage picture = noise(16, 8, 1, 8);
  write_picture(picture, folder / "a.png");
  std::string bytes = read_file(folder / "a.png");
  const std::string profile(
      "\x00\x00\x00\x07\x69\x43\x43\x50\x78\x00\x00\x6a\x75\x6e\x6b\x7f\x92\xb4\x9f", 19);
  bytes.insert(33, profile);
  write_file(folder / "a.png", bytes);
  testing::internal::CaptureStderr();
  EXPECT_EQ(read_picture(folder / "a.png").values, picture.values);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(PictureFile, WhatCannotBeWrittenIsSaid) {
  const TestFolder folder;
  const CameraImage picture = noise(8, 8, 1, 16);
  EXPECT_TRUE(says(error_of([&] { write_picture(picture, folder / "a.jpg"); }), "a.jpg", "16"));
  EXPECT_TRUE(says(error_of([&] { write_picture(picture, folder / "a.bmp"); }), ".bmp", ".png"));
  EXPECT_TRUE(says(error_of([&] { write_picture(picture, folder / "no/a.png"); }), "no/a.png"));
  EXPECT_TRUE(says(error_of([&] { encode_jpeg(picture, 90); }), "16"));
}

TEST(Mask, ValuesSnapToTheNearestLabelAndGoBackAndForth) {
  CameraImage mask{Image<std::uint16_t>(6, 1), 8};
  mask.values.values() = {0, 63, 65, 190, 193, 255};
  const Silhouette silhouette = silhouette_from_mask(mask);
  using enum PixelLabel;
  EXPECT_EQ(silhouette.values(),
            (std::vector<PixelLabel>{background, background, unknown, unknown, hand, hand}));
  const CameraImage snapped = mask_from_silhouette(silhouette);
  EXPECT_EQ(snapped.values.values(), (std::vector<std::uint16_t>{0, 0, 128, 128, 255, 255}));
  EXPECT_EQ(silhouette_from_mask(snapped), silhouette);
}

TEST(Mask, SixteenBitsAndThreeEqualChannelsAreMasksToo) {
  CameraImage mask{Image<std::uint16_t>(2, 1, 0, 3), 16};
  mask.values.values() = {65535, 65535, 65535, 32896, 32896, 32896};
  const Silhouette silhouette = silhouette_from_mask(mask);
  EXPECT_EQ(silhouette(0, 0), PixelLabel::hand);
  EXPECT_EQ(silhouette(1, 0), PixelLabel::unknown);
}

TEST(Mask, ColoursAndMasksOfZeroAndOneAreRefused) {
  CameraImage colour{Image<std::uint16_t>(1, 1, 0, 3), 8};
  colour.values(0, 0, 0) = 255;
  EXPECT_TRUE(says(error_of([&] { silhouette_from_mask(colour); }), "colour", "128"));
  CameraImage binary{Image<std::uint16_t>(2, 1), 8};
  binary.values(1, 0) = 1;
  EXPECT_TRUE(says(error_of([&] { silhouette_from_mask(binary); }), "0 and 1", "255"));
}

}  // namespace
}  // namespace tegata
