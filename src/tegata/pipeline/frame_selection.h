// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/take/take.h"

namespace tegata {

/// Which frames of a take are used: first, first + step, ... up to and including last.
struct FrameSelection {
  std::size_t first = 0;
  std::optional<std::size_t> last;
  std::size_t step = 1;
};

/// The indices of the frames. Throws Error where the take has none such.
std::vector<std::size_t> selected_frames(const FrameSelection& selection, const Take& take);

/// Frames that are decoded ahead and then worked on side by side.
inline constexpr std::size_t kFramesAtOnce = 8;

/// Decodes frames a few at a time. `work(i, pictures)` is called for i = 0 .. indices.size() - 1
/// from several threads; then, for each i in order, `finish(i)` from one.
struct FrameWork {
  std::function<void(std::size_t i, const TakeFrame& pictures)> work;
  std::function<void(std::size_t i)> finish;
  std::string_view stage = "hulls";  ///< what progress is called
};
void for_each_frame(Take& take, const std::vector<std::size_t>& indices, int threads,
                    const FrameWork& frame_work, const Observer& observer);

}  // namespace tegata
