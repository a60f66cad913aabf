// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "tegata/fit/fit_frame.h"

namespace tegata {

/// Frames that are handed out one by one: the pictures of a long take do not fit into memory all at
/// once.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual std::size_t size() const = 0;
  /// From any thread. A frame lasts as long as somebody keeps it.
  virtual std::shared_ptr<const FitFrame> frame(std::size_t i) const = 0;
};

/// Frames that somebody else keeps.
class GivenFrames final : public FrameSource {
 public:
  explicit GivenFrames(std::span<const FitFrame* const> frames)
      : frames_(frames.begin(), frames.end()) {}

  std::size_t size() const override { return frames_.size(); }
  std::shared_ptr<const FitFrame> frame(std::size_t i) const override {
    return {std::shared_ptr<const FitFrame>(), frames_[i]};
  }

 private:
  std::vector<const FitFrame*> frames_;
};

}  // namespace tegata
