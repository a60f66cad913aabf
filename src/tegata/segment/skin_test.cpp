// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>

#include "tegata/base/error.h"
#include "tegata/base/random.h"

namespace tegata {
namespace {

constexpr int kRoomWidth = 240, kRoomHeight = 200;
using Colour3 = std::array<double, 3>;

// An arm from the left edge that ends in a disk.
double outside_arm(int x, int y) {
  const double arm = std::hypot(x - std::min(static_cast<double>(x), 130.2), y - 100.3) - 22.0;
  return std::min(arm, std::hypot(x - 150.2, y - 100.3) - 35.0);
}

Colour3 room(int x, int y) {
  if (y < 40 && x < 120) return {176.0, 160.0, 142.0};  // cardboard
  if (x > 60 && y > 110) return {30.0, 34.0, 36.0};     // a dark mat, under half of the hand
  if (x < 50) return {215.0, 205.0, 203.0};             // a shirt
  return {190.0, 198.0, 196.0};                         // a desk
}

// Skin of a colour, lit from above, in front of the room.
CameraImage photograph(const Colour3& skin, Random& random, bool hand = true) {
  CameraImage picture{Image<std::uint16_t>(kRoomWidth, kRoomHeight, 0, 3), 8};
  for (int y = 0; y < kRoomHeight; ++y) {
    for (int x = 0; x < kRoomWidth; ++x) {
      const double share = hand ? 0.5 * std::erfc(outside_arm(x, y) / 1.4) : 0.0;
      const double light = 1.1 - 0.008 * (y - 65);
      const Colour3 behind = room(x, y);
      for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(c);
        const double value =
            behind[i] + share * (light * skin[i] - behind[i]) + random.normal(0.0, 2.0);
        picture.values(x, y, c) =
            static_cast<std::uint16_t>(std::clamp(std::lround(value), 0L, 255L));
      }
    }
  }
  return picture;
}

Silhouette arm_truth() {
  Silhouette silhouette(kRoomWidth, kRoomHeight);
  for (int y = 0; y < kRoomHeight; ++y) {
    for (int x = 0; x < kRoomWidth; ++x) {
      if (outside_arm(x, y) < 0.0) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

int component_count(const Silhouette& silhouette) {
  cv::Mat mask(silhouette.height(), silhouette.width(), CV_8U), labels;
  std::transform(silhouette.values().begin(), silhouette.values().end(), mask.begin<uchar>(),
                 [](PixelLabel label) { return static_cast<uchar>(label); });
  return cv::connectedComponents(mask, labels, 8) - 1;
}

TEST(SegmentSkin, FindsLightAndDarkSkinBeforeLightAndDark) {
  Random random(1);
  for (const Colour3& skin : {Colour3{222.0, 172.0, 146.0}, Colour3{190.0, 140.0, 110.0},
                              Colour3{140.0, 92.0, 66.0}, Colour3{92.0, 60.0, 46.0}}) {
    const Silhouette found = segment_skin(photograph(skin, random));
    EXPECT_GT(intersection_over_union(found, arm_truth()), 0.97) << "red " << skin[0];
    EXPECT_EQ(component_count(found), 1);
  }
}

TEST(SegmentSkin, ARoomWithoutSkinIsEmpty) {
  Random random(2);
  const CameraImage picture = photograph({}, random, false);
  SegmentationReport report;
  EXPECT_EQ(count_pixels(segment_skin(picture, {}, &report), PixelLabel::hand), 0U);
  EXPECT_EQ(report.hand_pixels, 0U);
}

TEST(SegmentSkin, RefusesAPictureOfOneChannel) {
  EXPECT_THROW(segment_skin({Image<std::uint16_t>(20, 20), 8}), Error);
  EXPECT_THROW(segment_skin(CameraImage{}), Error);
}

// A real forearm and hand over a cluttered desk, which take 5 to 11 % of these frames.
TEST(SegmentSkin, FindsOneArmInARecording) {
  const std::filesystem::path folder = std::filesystem::path(TEGATA_DATA_DIR) / "hand_2cam";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  for (const int camera : {0, 1}) {
    cv::VideoCapture video((folder / ("cam" + std::to_string(camera) + ".mp4")).string());
    cv::Mat frame;
    for (int i = 0; i < 81 && video.read(frame); ++i) {
      if (i % 40 != 0 || i == 0) continue;
      CameraImage picture{Image<std::uint16_t>(frame.cols, frame.rows, 0, 3), 8};
      for (int y = 0; y < frame.rows; ++y) {
        for (int x = 0; x < frame.cols; ++x) {
          for (int c = 0; c < 3; ++c) picture.values(x, y, c) = frame.at<cv::Vec3b>(y, x)[2 - c];
        }
      }
      const Silhouette found = segment_skin(picture);
      EXPECT_EQ(component_count(found), 1);
      const auto area = static_cast<double>(count_pixels(found, PixelLabel::hand));
      EXPECT_GT(area, 0.05 * frame.rows * frame.cols) << camera << ' ' << i;
      EXPECT_LT(area, 0.11 * frame.rows * frame.cols) << camera << ' ' << i;
      // The beige boxes, the shirt, and the mouse's pad are not skin.
      if (camera == 0) {
        EXPECT_EQ(found(100, 120), PixelLabel::background);
      }
      if (camera == 1) {
        EXPECT_EQ(found(60, 150), PixelLabel::background);
      }
    }
  }
}

}  // namespace
}  // namespace tegata
