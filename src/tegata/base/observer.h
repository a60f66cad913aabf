// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace tegata {

/// Where a long computation says how far it is and what it noticed. Either function may be empty;
/// both may be called from any thread, but never from two at once.
struct Observer {
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> on_progress;
  std::function<void(std::string_view message)> on_warning;

  /// Says that `done` of `total` steps of a stage are finished.
  void progress(std::string_view stage, std::size_t done, std::size_t total) const {
    if (on_progress) on_progress(stage, done, total);
  }
  /// Says in one line what a user should know of but that stops nothing.
  void warn(std::string_view message) const {
    if (on_warning) on_warning(message);
  }
};

}  // namespace tegata
