// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/frame_choice.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace tegata {

std::vector<std::size_t> choose_frames(std::span<const double> severities, std::size_t most) {
  const std::size_t count = severities.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (count <= most) return order;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return severities[a] > severities[b]; });
  std::set<std::size_t> chosen(order.begin(),
                               order.begin() + static_cast<std::ptrdiff_t>((most + 3) / 4));
  const std::size_t spread = most - chosen.size();
  for (std::size_t i = 0; i < spread; ++i) chosen.insert(i * count / spread);
  return {chosen.begin(), chosen.end()};
}

std::vector<std::size_t> choose_frames_by_size(std::span<const double> severities,
                                               std::span<const std::size_t> bytes,
                                               std::size_t most_bytes) {
  std::size_t most = severities.size();
  while (true) {
    std::vector<std::size_t> chosen = choose_frames(severities, most);
    std::size_t sum = 0;
    for (const std::size_t i : chosen) sum += bytes[i];
    if (sum <= most_bytes) return chosen;
    // As many as would fit if all were alike, and always fewer than before.
    most = std::min(most - 1, most * most_bytes / sum);
  }
}

}  // namespace tegata
