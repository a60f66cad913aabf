// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/infrared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/base/random.h"

namespace tegata {
namespace {

constexpr int kWidth = 320, kHeight = 240;

// A palm with four fingers 15 pixels thick and gaps of 4 pixels between them: negative inside.
double hand_distance(double x, double y) {
  const auto capsule = [&](double x0, double y0, double x1, double y1, double radius) {
    const double dx = x1 - x0, dy = y1 - y0;
    const double along =
        std::clamp(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(x - x0 - along * dx, y - y0 - along * dy) - radius;
  };
  double distance = std::hypot(x - 170.3, y - 150.7) - 40.0;
  for (int finger = 0; finger < 4; ++finger) {
    const double root = 141.5 + 19.0 * finger;
    distance = std::min(distance, capsule(root, 130.0, root + 6.0 * (finger - 1.5), 50.0, 7.5));
  }
  return distance;
}

struct Scene {
  double contrast = 0.45, noise = 0.015, blur_px = 1.0, vignetting = 0.25;
  bool hand = true;
  int bits = 8;
};

// The scene as a camera sees it: shares of hand in each pixel by its distance to the border under a
// Gaussian blur, a slope and a lamp's glow in the background, less light in the corners.
CameraImage photograph(const Scene& scene, Random& random) {
  CameraImage picture{Image<std::uint16_t>(kWidth, kHeight), scene.bits};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double share =
          scene.hand ? 0.5 * std::erfc(hand_distance(x, y) / (std::sqrt(2.0) * scene.blur_px))
                     : 0.0;
      const double u = 2.0 * x / kWidth - 1.0, v = 2.0 * y / kHeight - 1.0;
      const double glow = 0.05 * std::exp(-8.0 * ((u - 0.6) * (u - 0.6) + (v + 0.5) * (v + 0.5)));
      const double room = 0.25 + 0.02 * u + glow;
      const double skin = room + scene.contrast + 0.04 * std::sin(0.15 * x) * std::sin(0.12 * y);
      const double light = 1.0 - scene.vignetting * (u * u + v * v) / 2.0;
      const double value = light * (room + share * (skin - room)) + random.normal(0.0, scene.noise);
      // 16 bits as thermal cameras give them: a large offset and few counts of contrast.
      const double counts = scene.bits == 8 ? 255.0 * value : 7000.0 + 2500.0 * value;
      picture.values(x, y) = static_cast<std::uint16_t>(
          std::clamp(std::lround(counts), 0L, scene.bits == 8 ? 255L : 65535L));
    }
  }
  return picture;
}

Silhouette truth() {
  Silhouette silhouette(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (hand_distance(x, y) < 0.0) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

double hand_area(const Silhouette& silhouette) {
  return static_cast<double>(count_pixels(silhouette, PixelLabel::hand));
}

TEST(SegmentInfrared, FindsTheHandWithoutBiasUnderVignettingBlurAndNoise) {
  Random random(1);
  for (const int bits : {8, 16}) {
    for (const double blur : {0.8, 1.2}) {
      for (const double noise : {0.01, 0.02}) {
        const CameraImage picture = photograph({0.45, noise, blur, 0.25, true, bits}, random);
        SegmentationReport report;
        const Silhouette found = segment_infrared(picture, {}, &report);
        EXPECT_GT(intersection_over_union(found, truth()), 0.98)
            << bits << ' ' << blur << ' ' << noise;
        EXPECT_NEAR(hand_area(found) / hand_area(truth()), 1.0, 0.01)
            << bits << ' ' << blur << ' ' << noise;
        EXPECT_EQ(report.hand_pixels, count_pixels(found, PixelLabel::hand));
      }
    }
  }
}

TEST(SegmentInfrared, APictureWithoutAHandIsEmpty) {
  Random random(2);
  for (const int bits : {8, 16}) {
    for (const double noise : {0.0, 0.002, 0.02}) {
      const CameraImage picture = photograph({0.45, noise, 1.0, 0.25, false, bits}, random);
      EXPECT_EQ(hand_area(segment_infrared(picture)), 0.0) << bits << ' ' << noise;
    }
  }
  EXPECT_EQ(hand_area(segment_infrared({Image<std::uint16_t>(kWidth, kHeight, 90), 8})), 0.0);
}

TEST(SegmentInfrared, AHandNoBrighterThanTheNoiseIsNotGuessed) {
  Random random(3);
  EXPECT_EQ(hand_area(segment_infrared(photograph({0.03, 0.03, 1.0, 0.25, true, 16}, random))),
            0.0);
}

TEST(SegmentInfrared, KeepsHolesAndDropsHotPixelsAndPinholes) {
  Random random(4);
  CameraImage picture = photograph({}, random);
  const auto paint = [&](int x0, int y0, int size, std::uint16_t value) {
    for (int y = y0; y < y0 + size; ++y) {
      for (int x = x0; x < x0 + size; ++x) picture.values(x, y) = value;
    }
  };
  paint(20, 200, 3, 250);   // a lamp
  paint(160, 140, 3, 60);   // a reflection
  paint(165, 160, 12, 60);  // what shows between two fingers
  const Silhouette found = segment_infrared(picture);
  EXPECT_EQ(found(21, 201), PixelLabel::background);
  EXPECT_EQ(found(161, 141), PixelLabel::hand);
  EXPECT_EQ(found(171, 166), PixelLabel::background);
}

TEST(SegmentInfrared, TakesTheMeanOfThreeChannels) {
  Random random(5);
  const CameraImage grey = photograph({}, random);
  CameraImage colour{Image<std::uint16_t>(kWidth, kHeight, 0, 3), 8};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < 3; ++c) colour.values(x, y, c) = grey.values(x, y);
    }
  }
  EXPECT_EQ(segment_infrared(colour), segment_infrared(grey));
}

// The palm's lower part in cloth that is nearer to the skin's warmth than to the room's, and a
// finger that is cold.
TEST(SegmentInfrared, LeavesOutASleeveAndKeepsAColdFinger) {
  Random random(6);
  constexpr int kCuff = 160;
  CameraImage picture = photograph({}, random);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool is_sleeve = y > kCuff && std::abs(x - 170) < 45;
      const bool is_cold = y < 70 && x < 145 && hand_distance(x, y) < 0.0;
      if (is_sleeve) picture.values(x, y) = 110;
      if (is_cold) picture.values(x, y) = 115;
    }
  }
  const Silhouette found = segment_infrared(picture);
  EXPECT_EQ(found(170, kCuff - 5), PixelLabel::hand);
  EXPECT_EQ(found(170, kCuff + 5), PixelLabel::background);
  EXPECT_EQ(found(135, 60), PixelLabel::hand);
  Silhouette above = truth();
  for (int y = kCuff; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) above(x, y) = PixelLabel::background;
  }
  EXPECT_GT(intersection_over_union(found, above), 0.96);
}

TEST(SegmentInfrared, SkinThatIsWarmerHereThanThereStaysWhole) {
  Random random(7);
  CameraImage picture = photograph({}, random);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (hand_distance(x, y) > 0.0) continue;
      picture.values(x, y) = static_cast<std::uint16_t>(picture.values(x, y) - 0.4 * (190 - y));
    }
  }
  EXPECT_GT(intersection_over_union(segment_infrared(picture), truth()), 0.95);
}

CameraImage read(const std::filesystem::path& file) {
  const cv::Mat read = cv::imread(file.string(), cv::IMREAD_ANYDEPTH | cv::IMREAD_GRAYSCALE);
  CameraImage picture{Image<std::uint16_t>(read.cols, read.rows), read.depth() == CV_16U ? 16 : 8};
  for (int y = 0; y < read.rows; ++y) {
    for (int x = 0; x < read.cols; ++x) {
      picture.values(x, y) =
          picture.bits == 16 ? read.at<std::uint16_t>(y, x) : read.at<std::uint8_t>(y, x);
    }
  }
  return picture;
}

double hand_area(const Silhouette& silhouette, const cv::Rect& box) {
  double count = 0.0;
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      count += silhouette(x, y) == PixelLabel::hand ? 1.0 : 0.0;
    }
  }
  return count;
}

// Two bare hands of about 2,500 pixels each; sleeves and a lap are warm as well.
TEST(SegmentInfrared, FindsBothHandsOfThermalFramesAndLittleElse) {
  const std::filesystem::path folder = std::filesystem::path(TEGATA_DATA_DIR) / "thermal_hands";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const cv::Rect left(60, 105, 95, 95), right(185, 105, 90, 90);
  for (int i = 1; i <= 16; ++i) {
    const Silhouette found = segment_infrared(read(folder / (std::to_string(i) + "_raw.png")));
    const double in_left = hand_area(found, left), in_right = hand_area(found, right);
    EXPECT_GT(in_left, 2000.0) << i;
    EXPECT_GT(in_right, 2000.0) << i;
    EXPECT_LT(hand_area(found) - in_left - in_right, 0.02 * 320 * 256) << i;
  }
}

// The hands of both stills hold a cup and a bottle, with a mug between them.
TEST(SegmentInfrared, CutsMugAndBottleOutOfTheHands) {
  const std::filesystem::path folder = std::filesystem::path(TEGATA_DATA_DIR) / "thermal_hands";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  using Points = std::vector<std::array<int, 2>>;
  const auto check = [&](const char* name, const Points& skin, const Points& others) {
    const Silhouette found = segment_infrared(read(folder / name));
    for (const auto& [x, y] : skin) {
      EXPECT_EQ(found(x, y), PixelLabel::hand) << name << ' ' << x << ' ' << y;
    }
    for (const auto& [x, y] : others) {
      EXPECT_EQ(found(x, y), PixelLabel::background) << name << ' ' << x << ' ' << y;
    }
  };
  // Backs of the hands, forearms, thumbs and the right index finger; cup, mug, bottle and table.
  check("thermal_hands.png",
        {{118, 410}, {400, 340}, {112, 460}, {470, 430}, {184, 310}, {350, 345}, {358, 280}},
        {{168, 284}, {172, 300}, {244, 265}, {220, 335}, {315, 300}, {456, 330}, {320, 100}});
  // Here the bottle shines where it mirrors the lamp; asked for are its neck, its dark side and its
  // end.
  check("ir_hands.png", {{171, 353}, {496, 302}, {135, 445}, {570, 420}},
        {{224, 272}, {302, 222}, {317, 297}, {348, 222}, {430, 292}, {572, 295}, {322, 151}});
}

// Active infrared: skin darkens where it turns away from the lamp, where the depth still sees it.
TEST(SegmentInfrared, FindsFistsWhereTheDepthSeesThem) {
  const std::filesystem::path folder = std::filesystem::path(TEGATA_DATA_DIR) / "infrared_fists";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const cv::Rect region(225, 180, 75, 90);  // around the fist, from the wrist on
  constexpr int kNear = 700;                // [mm]; what lies behind is beyond 900
  std::vector<double> overlaps;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    const std::size_t at = name.find("ir_raw");
    if (at == std::string::npos) continue;
    const Silhouette found = segment_infrared(read(entry.path()));
    const CameraImage depth = read(folder / name.replace(at, 2, "depth"));
    double both = 0.0, either = 0.0;
    for (int y = region.y; y < region.y + region.height; ++y) {
      for (int x = region.x; x < region.x + region.width; ++x) {
        if (depth.values(x, y) == 0) continue;  // the depth does not know
        const bool near = depth.values(x, y) < kNear;
        const bool hand = found(x, y) == PixelLabel::hand;
        both += near && hand ? 1.0 : 0.0;
        either += near || hand ? 1.0 : 0.0;
      }
    }
    overlaps.push_back(both / either);
  }
  ASSERT_EQ(overlaps.size(), 8u);
  std::sort(overlaps.begin(), overlaps.end());
  EXPECT_GT(overlaps[0], 0.78);
  EXPECT_GT(0.5 * (overlaps[3] + overlaps[4]), 0.85);
}

TEST(SegmentInfrared, RefusesAnEmptyPicture) {
  EXPECT_THROW(segment_infrared(CameraImage{}), Error);
}

}  // namespace
}  // namespace tegata
