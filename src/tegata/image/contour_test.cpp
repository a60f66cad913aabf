// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tegata {
namespace {

const Eigen::Vector2d kCenter(61.3, 58.8);

Silhouette disk(double radius) {
  Silhouette silhouette(130, 120);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 130; ++x) {
      if ((Eigen::Vector2d(x, y) - kCenter).norm() < radius) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

// Root of the mean square.
struct Spread {
  double squares = 0.0;
  int count = 0;
  void add(double error) {
    squares += error * error;
    ++count;
  }
  double rms() const { return std::sqrt(squares / count); }
};

TEST(Contour, LiesOnTheCircleWithNormalsOutwards) {
  for (const double radius : {8.0, 12.0, 25.0, 50.0}) {
    Spread position, turn;
    double mean = 0.0;
    for (const ContourPoint& point : silhouette_contour(disk(radius))) {
      const Eigen::Vector2d from_center = point.pixel - kCenter;
      EXPECT_NEAR(point.normal.norm(), 1.0, 1e-12);
      position.add(from_center.norm() - radius);
      mean += from_center.norm() - radius;
      turn.add(std::acos(std::min(1.0, point.normal.dot(from_center.normalized()))) * 180.0 /
               std::numbers::pi);
    }
    EXPECT_LT(position.rms(), 0.15) << radius;
    EXPECT_NEAR(mean / position.count, 0.0, 0.04) << radius;  // fingers must not get thinner
    EXPECT_LT(turn.rms(), 3.0) << radius;
    EXPECT_GT(position.count, 6.0 * radius);  // a circle crosses 8 r borders between pixels
  }
}

TEST(Contour, AStraightEdgeStaysStraight) {
  Silhouette silhouette(40, 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 17; ++x) silhouette(x, y) = PixelLabel::hand;
  }
  const auto contour = silhouette_contour(silhouette);
  EXPECT_EQ(contour.size(), 36U);  // not within two pixels of the picture's edge
  for (const ContourPoint& point : contour) {
    EXPECT_NEAR(point.pixel.x(), 16.5, 1e-6);
    EXPECT_NEAR(point.normal.x(), 1.0, 1e-6);
  }
}

TEST(Contour, SaysNothingBesideUnknownPixelsAndThePicturesEdge) {
  Silhouette silhouette = disk(70.0);  // reaches over all four sides
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 30; ++x) silhouette(x, y) = PixelLabel::unknown;
  }
  const auto contour = silhouette_contour(silhouette);
  EXPECT_FALSE(contour.empty());
  for (const ContourPoint& point : contour) {
    EXPECT_GT(point.pixel.x(), 31.0);
    EXPECT_GT(point.pixel.y(), 1.0);
    EXPECT_LT(point.pixel.x(), 128.0);
    EXPECT_LT(point.pixel.y(), 118.0);
    EXPECT_NEAR((point.pixel - kCenter).norm(), 70.0, 0.8);
  }
}

TEST(Contour, AHoleIsABorderWhoseNormalPointsIntoIt) {
  Silhouette silhouette = disk(15.0);
  for (PixelLabel& label : silhouette.values()) {
    label = label == PixelLabel::hand ? PixelLabel::background : PixelLabel::hand;
  }
  for (const ContourPoint& point : silhouette_contour(silhouette)) {
    EXPECT_LT(point.normal.dot(point.pixel - kCenter), -14.0);
  }
}

TEST(Contour, OfALineOnePixelWideIsFinite) {
  Silhouette silhouette(40, 40);
  for (int x = 5; x < 35; ++x) silhouette(x, 20) = PixelLabel::hand;
  const auto contour = silhouette_contour(silhouette);
  EXPECT_EQ(contour.size(), 62U);
  for (const ContourPoint& point : contour) {
    EXPECT_TRUE(point.pixel.allFinite());
    EXPECT_NEAR(point.normal.norm(), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace tegata
