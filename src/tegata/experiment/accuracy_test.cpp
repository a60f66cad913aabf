// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/accuracy.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tegata/base/error.h"

namespace tegata {
namespace {

Accuracy two_seeds() {
  Accuracy accuracy{2, 10, {}};
  for (const SimulatedMode mode : kAccuracyModes) accuracy.takes[mode].resize(6);
  accuracy.takes[SimulatedMode::mask] = {{1.0, 2.0, 3.0, 0.5}, {2.0, 2.0, 3.0, 0.5},
                                         {0.5, 2.0, 3.0, 1.0}, {9.0, 2.0, 3.0, 1.0},
                                         {0.5, 2.0, 3.0, 0.0}, {5.0, 2.0, 9.0, 0.0}};
  return accuracy;
}

TEST(Accuracy, RangeIsOfAllTakes) {
  const ErrorRange range =
      error_range(two_seeds().takes.at(SimulatedMode::mask), &TakeAccuracy::surface_mm);
  EXPECT_DOUBLE_EQ(range.mean, 3.0);
  EXPECT_DOUBLE_EQ(range.median, 2.0);
  EXPECT_DOUBLE_EQ(range.worst, 9.0);
  EXPECT_THROW(error_range({}, &TakeAccuracy::surface_mm), Error);
}

TEST(Accuracy, TextAndJsonTellModesAndTakesApart) {
  const std::string text = accuracy_text(two_seeds());
  EXPECT_NE(text.find("masks, object unknown         3.00    2.00    9.00"), std::string::npos)
      << text;
  EXPECT_NE(text.find("masks, object unknown         50 %"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(accuracy_json(two_seeds()));
  EXPECT_EQ(json["modes"]["mask"]["thumb_error_deg"]["worst"], 9.0);
  EXPECT_EQ(json["modes"]["clean"]["surface_error_mm"]["worst"], 0.0);
  const auto& take = json["modes"]["mask"]["takes"][3];
  EXPECT_EQ(take["grasp"], "pinch");
  EXPECT_EQ(take["seed"], 2);
  EXPECT_EQ(take["surface_error_mm"], 9.0);
}

TEST(Accuracy, RefusesNoSeedsAndNoFrames) {
  AccuracyOptions no_seeds, no_frames;
  no_seeds.seed_count = 0;
  no_frames.frame_count = 0;
  AccuracyOptions no_modes;
  no_modes.modes.clear();
  EXPECT_THROW(run_accuracy(no_modes, {}), Error);
  EXPECT_THROW(run_accuracy(no_seeds, {}), Error);
  EXPECT_THROW(run_accuracy(no_frames, {}), Error);
}

}  // namespace
}  // namespace tegata
