// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/agreeing_pieces.h"

#include <gtest/gtest.h>

#include "tegata/base/angle.h"
#include "tegata/base/random.h"
#include "tegata/pipeline/silhouettes.h"
#include "tegata/pipeline/test_take.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

constexpr int kClutterX = 36, kClutterY = 42;

bool is_clutter(int x, int y, int radius) {
  const int across = x - kClutterX, down = y - kClutterY;
  return across * across + down * down <= radius * radius;
}

Silhouette disc(int radius) {
  Silhouette silhouette(200, 160, PixelLabel::background);
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      if (is_clutter(x, y, radius)) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

// A warm hand; something else of another warmth beside it.
CameraImage warm_picture(const Silhouette& hand, int clutter, int radius) {
  constexpr int kRoom = 60, kSkin = 150;
  Random random(3);
  CameraImage picture{Image<std::uint16_t>(hand.width(), hand.height()), 8};
  for (int y = 0; y < hand.height(); ++y) {
    for (int x = 0; x < hand.width(); ++x) {
      const bool is_hand = hand(x, y) == PixelLabel::hand;
      const double value = is_hand                                   ? kSkin
                           : clutter > 0 && is_clutter(x, y, radius) ? clutter
                                                                     : kRoom;
      picture.values(x, y) = static_cast<std::uint16_t>(value + random.normal(0.0, 1.5) + 0.5);
    }
  }
  return picture;
}

TEST(AgreeingPieces, TheHandOfTheOtherViewsIsChosen) {
  const CameraRig rig = test::small_rig();
  HandCandidates candidates;
  std::vector<std::optional<Silhouette>> hands, with_clutter;
  for (std::size_t c = 0; c < 3; ++c) {
    candidates.push_back({test::small_silhouette(0, c)});
    hands.emplace_back(test::small_silhouette(0, c));
    with_clutter.push_back(c == 1 ? disc(30) : hands.back());
  }
  candidates[1].insert(candidates[1].begin(), disc(30));
  EXPECT_LT(disagreement(rig, hands), 1.0 * kDegree);
  EXPECT_GT(disagreement(rig, with_clutter), 3.0 * kDegree);
  EXPECT_EQ(agreeing_candidates(rig, candidates), (std::vector<std::size_t>{0, 1, 0}));
  // A candidate that is no better, and a camera without a picture, change nothing.
  candidates[1] = {test::small_silhouette(0, 1), disc(30)};
  candidates[2].clear();
  EXPECT_EQ(agreeing_candidates(rig, candidates), (std::vector<std::size_t>{0, 0, 0}));
}

TEST(AgreeingPieces, PiecesAreTheLargestOnesFirst) {
  Silhouette both = test::small_silhouette(0, 0);
  EXPECT_TRUE(pieces_alone(both).empty());
  const Silhouette hand = both, clutter = disc(20);
  for (std::size_t i = 0; i < both.values().size(); ++i) {
    if (clutter.values()[i] == PixelLabel::hand) both.values()[i] = PixelLabel::hand;
  }
  const std::vector<Silhouette> pieces = pieces_alone(both);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0], hand);
  EXPECT_EQ(pieces[1], clutter);
}

TEST(AgreeingPieces, WhatIsTakenOutLeavesItsSurroundings) {
  const Silhouette clutter = disc(30);
  Silhouette none(200, 160, PixelLabel::background);
  const CameraImage left = without_hand(warm_picture(none, 240, 30), clutter);
  for (const std::uint16_t value : left.values.values()) EXPECT_LT(value, 80);
}

// Of the hand's warmth it is a piece beside it; much warmer, and the hand is not even a piece.
TEST(AgreeingPieces, WarmClutterInOneViewDoesNotWin) {
  const TestFolder folder;
  write_calibration(test::small_rig(), folder / "calibration.toml");
  constexpr std::array<std::pair<int, int>, 3> kClutter = {{{0, 0}, {150, 30}, {245, 30}}};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::filesystem::path own = folder / "images" / test::small_rig()[c].name;
    std::filesystem::create_directories(own);
    for (std::size_t f = 0; f < kClutter.size(); ++f) {
      const auto [warmth, radius] = kClutter[f];
      write_picture(warm_picture(test::small_silhouette(f, c), c == 1 ? warmth : 0, radius),
                    own / text("00000", f, ".png"));
    }
  }
  Take take = Take::open(folder.path());
  const Segmenter segmenter(take, SegmentationMethod::infrared, {});
  for (std::size_t f = 0; f < kClutter.size(); ++f) {
    std::vector<SegmentationReport> reports;
    const auto silhouettes = segmenter.segment(take.read_frame(f, {}), &reports);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GT(intersection_over_union(*silhouettes[c], test::small_silhouette(f, c)), 0.95)
          << "frame " << f << ", camera " << c;
      EXPECT_EQ(reports[c].hand_pixels, count_pixels(*silhouettes[c], PixelLabel::hand));
    }
  }
}

}  // namespace
}  // namespace tegata
