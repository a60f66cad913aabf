// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/weight_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tegata {
namespace {

WeightRecord two_frames() {
  WeightRecord record;
  record.frames.resize(2);
  record.frames[0].name = "000000";
  record.frames[1].name = "000001";
  record.frames[0].weights.fill(1.0);
  record.frames[1].weights.fill(0.25);
  return record;
}

TEST(WeightChart, CsvHasARowForEachFrameAndBone) {
  const std::string csv = weights_csv(two_frames());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * kBoneCount);
  EXPECT_NE(csv.find("000001,index_distal,0.2500,0.0000\n"), std::string::npos);
}

TEST(WeightChart, SvgDrawsFullWeightAtTheTopAndNoneAtTheBottom) {
  const std::string svg = weights_svg(two_frames());
  EXPECT_NE(svg.find("points=\"34.0,26.0 154.0,108.5 \""), std::string::npos);
  EXPECT_NE(svg.find("points=\"34.0,136.0 154.0,136.0 \""), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

TEST(WeightChart, OneFrameIsDrawnToo) {
  WeightRecord record = two_frames();
  record.frames.pop_back();
  EXPECT_EQ(weights_svg(record).find("nan"), std::string::npos);
}

}  // namespace
}  // namespace tegata
