// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_html.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

TEST(ReportHtml, NamesCannotCloseTagsOrAttributes) {
  EXPECT_EQ(escape_html("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
}

TEST(ReportHtml, Base64MatchesTheTestVectorsOfItsStandard) {
  const auto encoded = [](const std::string& text) {
    return encode_base64({text.begin(), text.end()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode_base64({0xfb, 0xff, 0xfe}), "+//+");
}

TEST(ReportHtml, JointNamesAreSpokenWithTheirAbbreviations) {
  EXPECT_EQ(spoken_name("thumb_cmc_abduction"), "thumb CMC abduction");
  EXPECT_EQ(spoken_name("palm"), "palm");
}

}  // namespace
}  // namespace tegata
