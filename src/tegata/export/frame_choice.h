// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tegata {

/// Which frames a page keeps where it has room for `most` of them: for a quarter of the room the
/// most severe, evenly spread ones for the rest. All where there is room. Positions, sorted.
std::vector<std::size_t> choose_frames(std::span<const double> severities, std::size_t most);

/// The same for frames of different sizes: as many as take `most_bytes` together or less.
std::vector<std::size_t> choose_frames_by_size(std::span<const double> severities,
                                               std::span<const std::size_t> bytes,
                                               std::size_t most_bytes);

}  // namespace tegata
