// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "tegata/base/text.h"

namespace tegata {

/// Bad input. The message is one line: what was got, what was expected, where (file, key, frame,
/// camera) and what would do. Not converging is never an error but a value in a report.
class Error : public std::runtime_error {
 public:
  /// The parts are streamed one after the other into the message; what is quoted from a file may
  /// hold line breaks, the message does not.
  template <typename... Parts>
  explicit Error(const Parts&... parts) : std::runtime_error(one_line(text(parts...))) {}
};

}  // namespace tegata
