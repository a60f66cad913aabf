// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tegata/fit/view.h"

namespace tegata {

/// A view in a few kilobytes instead of megabytes: its silhouette row by row as runs of one label;
/// all else is made of that. What is known to stand about the hand (FitView::hiding_depth,
/// FitView::forearm) is not kept.
class StoredView {
 public:
  explicit StoredView(const FitView& view);

  const Camera& camera() const { return camera_; }
  Silhouette silhouette() const;
  /// make_fit_view() of the same silhouette.
  FitView restored() const { return make_fit_view(camera_, silhouette()); }

 private:
  struct Run {
    std::uint32_t length;
    PixelLabel label;
  };

  Camera camera_;
  std::vector<Run> runs_;
};

}  // namespace tegata
