// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace tegata {

/// The pictures of an AVI and which of them can be found in it.
struct AviIndex {
  std::size_t count = 0;           ///< as the file's index has it
  std::vector<std::size_t> found;  ///< whose head is where the index says, in order
};

/// By the index at the end (`idx1`). All zero for other files, for such without that index and for
/// those whose lists do not lead to it.
AviIndex read_avi_index(const std::filesystem::path& file);

}  // namespace tegata
