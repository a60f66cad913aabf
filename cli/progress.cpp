// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

namespace tegata {
namespace {

constexpr std::size_t kBarWidth = 30;
constexpr double kSecondsBetweenLines = 2.0;

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
  }
  if (terminal_) {
    draw_bar(done, total);
    return;
  }
  const std::size_t tenth = total == 0 ? 10 : 10 * done / total;
  if (tenth <= shown_tenth_) return;
  if (tenth < 10 && since_line_.seconds() < kSecondsBetweenLines) return;
  shown_tenth_ = tenth;
  since_line_ = Stopwatch();
  std::cerr << fmt::format("{}: {} of {}\n", stage_, done, total);
}

void Progress::warn(std::string_view message) {
  end_bar();
  std::cerr << "tegata: warning: " << message << "\n";
}

void Progress::draw_bar(std::size_t done, std::size_t total) {
  const std::size_t filled = total == 0 ? kBarWidth : kBarWidth * done / total;
  std::cerr << fmt::format("\r{:<20} [{:#<{}}{:.<{}}] {}/{} ", stage_, "", filled, "",
                           kBarWidth - filled, done, total)
            << std::flush;
  bar_is_open_ = true;
  if (done == total) end_bar();
}

void Progress::end_bar() {
  if (bar_is_open_) std::cerr << "\n";
  bar_is_open_ = false;
}

}  // namespace tegata
