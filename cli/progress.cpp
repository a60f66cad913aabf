// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace tegata {
namespace {

constexpr std::size_t kBarWidth = 30;
constexpr double kSecondsBetweenLines = 2.0;
constexpr double kSecondsBeforeGuess = 1.0;

/// A time as people say it, not finer than anybody can know: "7 s", "25 s", "4 min", "2.5 h".
std::string rough_time(double seconds) {
  if (seconds < 9.5) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  if (seconds < 87.5) return fmt::format("{:.0f} s", 5.0 * std::round(seconds / 5.0));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { end_bar(); }

Observer Progress::observer() {
  Observer observer;
  if (quiet_) return observer;
  observer.on_progress = [this](std::string_view stage, std::size_t done, std::size_t total) {
    show(stage, done, total);
  };
  observer.on_warning = [this](std::string_view message) { warn(message); };
  return observer;
}

void Progress::show(std::string_view stage, std::size_t done, std::size_t total) {
  if (stage != stage_) {
    end_bar();
    stage_ = stage;
    shown_tenth_ = 0;
    since_line_ = Stopwatch();
    // A stage that is first heard of when some of it is done began when the one before ended.
    since_stage_ = done == 0 ? Stopwatch() : since_report_;
  }
  since_report_ = Stopwatch();
  if (terminal_) {
    draw_bar(done, total);
    return;
  }
  const std::size_t tenth = total == 0 ? 10 : 10 * done / total;
  if (tenth <= shown_tenth_) return;
  if (tenth < 10 && since_line_.seconds() < kSecondsBetweenLines) return;
  shown_tenth_ = tenth;
  since_line_ = Stopwatch();
  std::cerr << fmt::format("{}: {} of {}{}\n", stage_, done, total, time_text(done, total));
}

void Progress::warn(std::string_view message) {
  end_bar();
  std::cerr << "tegata: warning: " << message << "\n";
}

void Progress::draw_bar(std::size_t done, std::size_t total) {
  const std::size_t filled = total == 0 ? kBarWidth : kBarWidth * done / total;
  constexpr std::string_view kEraseToEnd = "\x1b[K";
  std::cerr << fmt::format("\r{:<20} [{:#<{}}{:.<{}}] {}/{}{} {}", stage_, "", filled, "",
                           kBarWidth - filled, done, total, time_text(done, total), kEraseToEnd)
            << std::flush;
  bar_is_open_ = true;
  if (done == total) end_bar();
}

std::string Progress::time_text(std::size_t done, std::size_t total) const {
  const double seconds = since_stage_.seconds();
  if (done >= total) return fmt::format(", took {:.1f} s", seconds);
  if (done == 0 || seconds < kSecondsBeforeGuess) return {};
  const double pace = seconds / static_cast<double>(done);
  return fmt::format(", about {} left", rough_time(pace * static_cast<double>(total - done)));
}

void Progress::end_bar() {
  if (bar_is_open_) std::cerr << "\n";
  bar_is_open_ = false;
}

}  // namespace tegata
