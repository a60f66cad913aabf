// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "tegata/base/scratch_file.h"
#include "tegata/fit/start.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/pipeline/prepare_frame.h"

namespace tegata {

/// Prepared frames of a take, of which memory keeps little: silhouettes as runs of one label and
/// the hull's mesh, a few hundred kilobytes a frame, lie on disk; all else is made of these again.
/// What is known to stand about the hand (FitView::hiding_depth, FitView::forearm) is not kept.
class FrameStore {
 public:
  /// In a nameless file in `folder` (scratch_file.h); where that is empty, in memory after all.
  explicit FrameStore(const std::filesystem::path& folder);

  /// Cameras of one name must be the same in all frames.
  void add(PreparedFrame frame);
  void set_landmarks(std::size_t i, const std::optional<StartLandmarks>& landmarks);

  std::size_t size() const { return frames_.size(); }
  /// A frame without its views and its hull.
  const PreparedFrame& brief(std::size_t i) const { return frames_[i].brief; }
  /// Its views as they were seen, and its hull's mesh. From any thread, as what follows.
  std::vector<HullView> views(std::size_t i) const;
  TriangleMesh hull(std::size_t i) const;
  /// The whole frame again.
  PreparedFrame restored(std::size_t i) const;

 private:
  struct StoredFrame {
    PreparedFrame brief;
    ScratchFile::Place place;
    std::vector<std::byte> bytes;  // where there is no file
  };
  std::vector<std::byte> bytes_of(std::size_t i) const;

  std::optional<ScratchFile> file_;
  std::vector<Camera> cameras_;
  std::vector<StoredFrame> frames_;
};

}  // namespace tegata
