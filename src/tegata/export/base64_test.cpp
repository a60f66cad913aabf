// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/base64.h"

#include <gtest/gtest.h>

#include <vector>

namespace tegata {
namespace {

TEST(Base64, MatchesTheTestVectorsOfItsStandard) {
  const auto encoded = [](const std::string& text) {
    return encode_base64(std::vector<std::uint8_t>(text.begin(), text.end()));
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode_base64(std::vector<std::uint8_t>{0xfb, 0xff, 0xfe}), "+//+");
}

}  // namespace
}  // namespace tegata
