// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace tegata {

/// Bytes that wait on disk instead of in memory. The file has no name: it goes with the object, or
/// with the process, however that ends.
class ScratchFile {
 public:
  /// Where bytes were put.
  struct Place {
    std::uint64_t offset = 0;
    std::size_t size = 0;
  };

  /// On the disk of this folder, which must exist; one that is itself kept in memory, as /tmp often
  /// is, gains nothing. Throws Error naming it and the system's reason.
  explicit ScratchFile(std::filesystem::path folder);
  ~ScratchFile();
  ScratchFile(ScratchFile&& other) noexcept;
  ScratchFile& operator=(ScratchFile&& other) noexcept;

  /// By one thread at a time. Throws Error naming the folder and the system's reason (a full disk).
  Place append(std::span<const std::byte> bytes);
  /// From any thread, also while others read.
  std::vector<std::byte> read(const Place& place) const;

 private:
  std::filesystem::path folder_;  // for what is said
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace tegata
