// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_page.h"

#include <gtest/gtest.h>

#include "tegata/export/viewer_page.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

TEST(ReportPage, DataStandsWhereTheTemplateSays) {
  EXPECT_EQ(report_page("<p>a</p><!--tegata-report--><p>b</p>", "{\"x\":1}"),
            "<p>a</p><script type=\"application/json\" id=\"tegata-report\">{\"x\":1}</script>"
            "<p>b</p>");
}

TEST(ReportPage, TemplateWithoutAPlaceIsAnError) {
  EXPECT_TRUE(says(error_of([] { report_page("<p></p>", "{}"); }), "tegata-report"));
}

TEST(ReportPage, CarriedPageIsWholeAndNeedsNoNetwork) {
  const std::string_view page = viewer_page();
  if (page.empty()) GTEST_SKIP() << "built without the report page";
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.substr(page.size() - 16).find("</html>") != std::string_view::npos);
  const std::size_t place = page.find(kReportPlace);
  ASSERT_NE(place, std::string_view::npos);
  EXPECT_EQ(page.find(kReportPlace, place + 1), std::string_view::npos);
  for (const std::string_view outside : {" src=\"", " href=\"http", "@import", "import(\""}) {
    EXPECT_EQ(page.find(outside), std::string_view::npos) << outside;
  }
}

}  // namespace
}  // namespace tegata
