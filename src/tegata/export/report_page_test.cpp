// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>

#include "tegata/export/test_result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

std::string page_of(const Result& result, const std::vector<ReportPicture>& pictures) {
  const TestFolder folder;
  write_report_page(result, pictures, folder / "report.html");
  std::ifstream stream(folder / "report.html");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The first tag that is not closed in order, or nothing.
std::string unbalanced_tag(const std::string& page) {
  static const std::regex kTag("<(/?)([a-z0-9]+)((?:\\s[A-Za-z0-9-]+=\"[^\"<>]*\")*)\\s?(/?)>");
  std::vector<std::string> open;
  std::size_t tag_count = 0;
  const std::string body = page.substr(page.find("<html"));
  for (std::sregex_iterator tag(body.begin(), body.end(), kTag), end; tag != end; ++tag) {
    ++tag_count;
    if ((*tag)[4].length() > 0) continue;
    if ((*tag)[1].length() == 0) {
      open.push_back((*tag)[2]);
    } else if (open.empty() || open.back() != (*tag)[2]) {
      return (*tag)[0];
    } else {
      open.pop_back();
    }
  }
  const auto brackets = static_cast<std::size_t>(std::count(body.begin(), body.end(), '<'));
  if (tag_count != brackets) return "a '<' that opens no tag";
  return open.empty() ? "" : open.back();
}

TEST(ReportPage, IsWellFormedWhateverTheNames) {
  EXPECT_EQ(unbalanced_tag(page_of(test_result(6), {{"frame<0>", "\"left\"", {1, 2, 3}}})), "");
  EXPECT_EQ(unbalanced_tag(page_of(test_result(1), {})), "");
  EXPECT_EQ(unbalanced_tag("<html><b>x</i></html>"), "</i>");
  EXPECT_EQ(unbalanced_tag("<html>1 < 2</html>"), "a '<' that opens no tag");
}

TEST(ReportPage, NeedsNoNetwork) {
  const std::string page = page_of(test_result(4), {{"frame0", "left", {255, 216}}});
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<link"), std::string::npos);
  EXPECT_NE(page.find("src=\"data:image/jpeg;base64,/9g=\""), std::string::npos);
}

TEST(ReportPage, SaysWhyAFrameHasNoPose) {
  const std::string page = page_of(test_result(4), {});
  EXPECT_NE(page.find("seen by 1 camera &lt; 2"), std::string::npos);
  EXPECT_NE(page.find("3 of 4"), std::string::npos);
  EXPECT_NE(page.find("<td>0.75</td><td>0.50</td>"), std::string::npos);
}

TEST(ReportPage, NamesTheFileThatCannotBeWritten) {
  const TestFolder folder;
  const std::string message =
      error_of([&] { write_report_page(test_result(2), {}, folder / "missing" / "report.html"); });
  EXPECT_TRUE(says(message, "report.html"));
}

}  // namespace
}  // namespace tegata
