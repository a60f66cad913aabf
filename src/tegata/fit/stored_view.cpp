// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/stored_view.h"

#include <algorithm>

namespace tegata {

StoredView::StoredView(const FitView& view) : camera_(view.camera) {
  for (const PixelLabel label : view.silhouette.values()) {
    if (runs_.empty() || runs_.back().label != label) runs_.push_back({0, label});
    ++runs_.back().length;
  }
  runs_.shrink_to_fit();
}

Silhouette StoredView::silhouette() const {
  Silhouette silhouette(camera_.width, camera_.height);
  auto next = silhouette.values().begin();
  for (const Run& run : runs_) next = std::fill_n(next, run.length, run.label);
  return silhouette;
}

}  // namespace tegata
