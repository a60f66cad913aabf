// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/infrared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

TEST(SegmentInfrared, RefusesAnEmptyPicture) {
  EXPECT_THROW(segment_infrared(CameraImage{}), Error);
}

}  // namespace
}  // namespace tegata
