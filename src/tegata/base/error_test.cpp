// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/error.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

TEST(Error, PartsAreJoined) {
  EXPECT_STREQ(Error("got ", 3, ", expected 2 or more").what(), "got 3, expected 2 or more");
}

TEST(Error, LineBreaksAndOtherControlCharactersOfAQuoteStayOnOneLine) {
  EXPECT_STREQ(Error("hand = \"a\n\r\x1b[31mb\"").what(), R"(hand = "a\n\x0d\x1b[31mb")");
}

TEST(Error, LettersOfOtherScriptsAreKept) { EXPECT_STREQ(Error("take 手形").what(), "take 手形"); }

}  // namespace
}  // namespace tegata
