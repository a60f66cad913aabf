// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "rounds.h"

namespace tegata::bench {

/// What a benchmark found, printed as Markdown.
class Report {
 public:
  explicit Report(const std::string& title);

  /// One line of the table of times a contestant. `work` says on what.
  void add(const std::string& work, const std::vector<Contestant>& contestants,
           const std::vector<Timing>& timings);
  /// Something that must hold whatever the machine: `figure` is what was found.
  void check(const std::string& what, const std::string& figure, bool holds);
  /// A figure that no bar goes with.
  void note(const std::string& line);

  /// Prints all of it to stdout. Whether every check holds.
  bool print() const;

 private:
  std::string title_;
  std::vector<std::vector<std::string>> times_, checks_;
  std::vector<std::string> notes_;
  bool all_hold_ = true;
};

}  // namespace tegata::bench
