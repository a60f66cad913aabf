// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/frame_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tegata {
namespace {

TEST(FrameChoice, AllFramesStayWhereThereIsRoom) {
  const std::vector<double> severities = {0.0, 0.5, 0.1};
  EXPECT_EQ(choose_frames(severities, 3), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(choose_frames(severities, 0).empty());
  EXPECT_TRUE(choose_frames({}, 5).empty());
}

TEST(FrameChoice, WorstFramesStayAndTheOthersAreSpreadOverTheTake) {
  std::vector<double> severities(100, 0.1);
  severities[37] = 0.9;
  severities[93] = 0.8;
  const auto chosen = choose_frames(severities, 8);
  EXPECT_LE(chosen.size(), 8u);
  EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
  for (const std::size_t frame : {37u, 93u}) {
    EXPECT_TRUE(std::binary_search(chosen.begin(), chosen.end(), frame)) << frame;
  }
  for (std::size_t begin = 0; begin < 100; begin += 25) {
    EXPECT_TRUE(std::any_of(chosen.begin(), chosen.end(), [&](std::size_t i) {
      return i >= begin && i < begin + 25;
    })) << begin;
  }
}

TEST(FrameChoice, LargeFramesAreLeftOutUntilTheRestFits) {
  const std::vector<double> severities(60, 0.0);
  std::vector<std::size_t> bytes(60, 10);
  for (std::size_t i = 40; i < 60; ++i) bytes[i] = 100;
  for (const std::size_t most : {0u, 9u, 200u, 1000u, 2000u, 2400u}) {
    std::size_t sum = 0;
    for (const std::size_t i : choose_frames_by_size(severities, bytes, most)) sum += bytes[i];
    EXPECT_LE(sum, most);
    // Room for one more large frame or two stays empty, not half of the room.
    EXPECT_GE(sum, most >= 1000 ? most / 2 : 0);
  }
  EXPECT_EQ(choose_frames_by_size(severities, bytes, 2400).size(), 60u);
}

}  // namespace
}  // namespace tegata
