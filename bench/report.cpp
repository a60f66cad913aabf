// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <fmt/core.h>

#include <algorithm>

namespace tegata::bench {
namespace {

// Three digits, never with an exponent.
std::string three_digits(double value) {
  return value < 100.0 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 3);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < widths.size(); ++c) fmt::print("| {:<{}} ", rows[r][c], widths[c]);
    fmt::print("|\n");
    if (r > 0) continue;
    for (const std::size_t width : widths) fmt::print("| {:-<{}} ", "", width);
    fmt::print("|\n");
  }
  fmt::print("\n");
}

}  // namespace

Report::Report(const std::string& title)
    : title_(title),
      times_({{"work", "by", "ms", "ratio to ours", "to hold", "held"}}),
      checks_({{"check", "found", "holds"}}) {}

void Report::add(const std::string& work, const std::vector<Contestant>& contestants,
                 const std::vector<Timing>& timings) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const double bar = contestants[i].bar, ratio = timings[i].ratio;
    times_.push_back({work, contestants[i].name, three_digits(timings[i].milliseconds),
                      three_digits(ratio), bar > 0.0 ? fmt::format("{:g}", bar) : "",
                      bar > 0.0 ? (ratio >= bar ? "yes" : "no") : ""});
  }
}

void Report::check(const std::string& what, const std::string& figure, bool holds) {
  checks_.push_back({what, figure, holds ? "yes" : "NO"});
  all_hold_ = all_hold_ && holds;
}

void Report::note(const std::string& line) { notes_.push_back(line); }

bool Report::print() const {
  fmt::print("### {}\n\n", title_);
  if (times_.size() > 1) print_table(times_);
  if (checks_.size() > 1) print_table(checks_);
  for (const std::string& line : notes_) fmt::print("- {}\n", line);
  if (!notes_.empty()) fmt::print("\n");
  std::fflush(stdout);
  return all_hold_;
}

}  // namespace tegata::bench
