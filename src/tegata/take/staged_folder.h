// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tegata {

/// A folder that appears whole or not at all: files are written to a hidden sibling, which commit()
/// renames to its place. Without commit() the sibling is removed again.
class StagedFolder {
 public:
  /// Throws Error where `target` exists and `replace` is false, or where its parent cannot be
  /// written. The parent is made where it is missing. With a `marker`, an existing folder is only
  /// replaced if it is empty or holds a file of that name (say "result.json"), so that a mistyped
  /// target never costs anything but an older result.
  StagedFolder(std::filesystem::path target, bool replace, std::string_view marker = {});
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// Where to write until then.
  const std::filesystem::path& path() const { return staging_; }
  /// Puts the folder in its place; what it replaces is removed only after that worked.
  void commit();

 private:
  std::filesystem::path target_, staging_;
  bool replace_ = false;
  bool committed_ = false;
};

/// Writes a file whole. Throws Error naming the file and the system's reason (a full disk, a
/// missing permission).
void write_file(const std::filesystem::path& file, std::string_view content);

/// The bytes of a file. Throws Error naming the file and the system's reason.
std::string read_file(const std::filesystem::path& file);

}  // namespace tegata
