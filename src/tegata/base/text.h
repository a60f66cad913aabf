// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace tegata {

/// The parts streamed one after the other into one string.
template <typename... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

/// A text with its control characters written out (a line break as "\\n", others as "\\x1b"), so
/// that it prints as one line.
std::string one_line(std::string_view text);

}  // namespace tegata
