// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/silhouette.h"

#include <algorithm>

#include "tegata/base/error.h"

namespace tegata {

std::size_t count_pixels(const Silhouette& silhouette, PixelLabel label) {
  return static_cast<std::size_t>(
      std::count(silhouette.values().begin(), silhouette.values().end(), label));
}

double intersection_over_union(const Silhouette& a, const Silhouette& b) {
  if (a.width() != b.width() || a.height() != b.height()) {
    throw Error("intersection over union: got silhouettes of ", a.width(), " x ", a.height(),
                " and ", b.width(), " x ", b.height(), ", expected one size");
  }
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    const PixelLabel first = a.values()[i], second = b.values()[i];
    if (first == PixelLabel::unknown || second == PixelLabel::unknown) continue;
    const bool in_first = first == PixelLabel::hand, in_second = second == PixelLabel::hand;
    both += in_first && in_second ? 1 : 0;
    either += in_first || in_second ? 1 : 0;
  }
  return either == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(either);
}

}  // namespace tegata
