// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/table1.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tegata/base/error.h"
#include "tegata/experiment/table1_text.h"

namespace tegata {
namespace {

TEST(Table1, SpreadIsThatOfASample) {
  const ErrorSpread spread = spread_of({{1.0, 10.0}, {3.0, 10.0}});
  EXPECT_DOUBLE_EQ(spread.mean.surface_mm, 2.0);
  EXPECT_DOUBLE_EQ(spread.deviation.surface_mm, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(spread.deviation.angle_deg, 0.0);
  EXPECT_DOUBLE_EQ(spread_of({{4.0, 5.0}}).deviation.surface_mm, 0.0);
}

TEST(Table1, TextAndJsonTellTheFitsApart) {
  Table1 table;
  table.seed_count = 2;
  table.frame_count = 5;
  for (auto& of_grasp : table.of_seeds) of_grasp.fill({{0.0, 0.0}, {0.0, 0.0}});
  table.errors[2][static_cast<std::size_t>(Table1Fit::default_all)] = {{1.25, 7.5}, {0.5, 2.0}};
  const std::string text = table1_text(table);
  EXPECT_NE(text.find("default, all frames                0.0 +- 0.0         0.0 +- 0.0         "
                      "7.5 +- 2.0"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("8.3 to 10.9"), std::string::npos);
  EXPECT_NE(table1_json(table).find("\"default_all\":{\"surface_error_mm\":{\"mean\":1.25"),
            std::string::npos)
      << table1_json(table);
}

TEST(Table1, RefusesNoSeedsAndNoFrames) {
  Table1Options no_seeds, no_frames;
  no_seeds.seed_count = 0;
  no_frames.frame_count = 0;
  EXPECT_THROW(run_table1(no_seeds, {}), Error);
  EXPECT_THROW(run_table1(no_frames, {}), Error);
}

}  // namespace
}  // namespace tegata
