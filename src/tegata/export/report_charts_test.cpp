// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_charts.h"

#include <gtest/gtest.h>

#include "tegata/export/test_result.h"

namespace tegata {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(ReportCharts, FrameWithoutPoseLeavesAGap) {
  Result result = test_result(7);
  result.frames[3].pose.reset();
  const std::string chart = angle_chart(result, 1);
  EXPECT_EQ(count(chart, "<circle"), 4u * 5u);
  const std::size_t path = chart.find("<path");
  const std::string first = chart.substr(path, chart.find("/>", path) - path);
  EXPECT_EQ(count(first, "M"), 2u) << first;
  EXPECT_EQ(count(first, " L"), 3u) << first;
}

TEST(ReportCharts, SingleFrameIsDrawn) {
  const std::string chart = angle_chart(test_result(1), 0);
  EXPECT_EQ(count(chart, "<circle"), 4u);
  EXPECT_EQ(count(chart, "nan"), 0u);
  EXPECT_EQ(count(chart, ">frame0<"), 1u);
}

TEST(ReportCharts, SteepAnglesStayInsideTheChart) {
  Result result = test_result(3);
  result.frames[0].pose->angles[5] = 2.9;
  result.frames[1].pose->angles[6] = -1.1;
  const std::string chart = angle_chart(result, 1);
  for (std::size_t at = chart.find("cy=\""); at != std::string::npos;
       at = chart.find("cy=\"", at + 1)) {
    const double y = std::stod(chart.substr(at + 4));
    EXPECT_GE(y, 0.0);
    EXPECT_LE(y, 210.0);
  }
}

TEST(ReportCharts, SupportHasACellForEachBoneAndFrame) {
  const std::string table = support_table(test_result(5));
  EXPECT_EQ(count(table, "<td title"), 4u * kBoneCount);
  EXPECT_EQ(count(table, "<td class=\"none\">"), 1u * kBoneCount);
  EXPECT_EQ(count(table, "thumb metacarpal, frame2: 0.25"), 1u);
}

TEST(ReportCharts, LongTakesDoNotPrintNumbersThatCannotBeRead) {
  const std::string table = support_table(test_result(100));
  EXPECT_EQ(count(table, ">0.25<"), 0u);
  EXPECT_EQ(count(table, "<td title"), 99u * kBoneCount);
}

}  // namespace
}  // namespace tegata
