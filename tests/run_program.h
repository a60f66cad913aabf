// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tegata {

/// What a run of the program gave.
struct ProgramRun {
  int exit_code = -1;  ///< 128 + the signal's number where it was killed
  std::string out, err;
  /// The lines of stderr.
  std::vector<std::string> error_lines() const;
};

/// Runs the built program. With `largest_file` [bytes] writing more into one file fails, as on a
/// disk that fills up.
ProgramRun run_program(const std::vector<std::string>& arguments,
                       std::optional<std::uint64_t> largest_file = std::nullopt);

/// The names in a folder, hidden ones as well, in order.
std::vector<std::string> names_in(const std::filesystem::path& folder);

std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& content);
/// Replaces the first occurrence of `from`; a test failure where there is none.
void replace_in_file(const std::filesystem::path& file, const std::string& from,
                     const std::string& to);

}  // namespace tegata
