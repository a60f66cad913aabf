// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tegata/base/observer.h"
#include "tegata/base/stopwatch.h"

namespace tegata {

/// Progress and warnings on stderr, with how long a stage will still take as far as its pace tells:
/// a bar on a terminal; elsewhere a line for each finished stage, and for each further tenth of a
/// long one.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Says what happens to this object, which must outlive it.
  Observer observer();

 private:
  void show(std::string_view stage, std::size_t done, std::size_t total);
  void warn(std::string_view message);
  void draw_bar(std::size_t done, std::size_t total);
  std::string time_text(std::size_t done, std::size_t total) const;
  void end_bar();

  bool quiet_;
  bool terminal_;
  bool bar_is_open_ = false;
  std::string stage_;
  std::size_t shown_tenth_ = 0;
  Stopwatch since_report_, since_stage_, since_line_;
};

}  // namespace tegata
