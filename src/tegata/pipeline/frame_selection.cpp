// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/frame_selection.h"

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"

namespace tegata {

std::vector<std::size_t> selected_frames(const FrameSelection& selection, const Take& take) {
  const std::size_t count = take.frame_names().size();
  const std::size_t last = std::min(selection.last.value_or(count - 1), count - 1);
  if (selection.first > last || selection.step == 0) {
    throw Error("frames: got first ", selection.first, ", last ", last, " and step ",
                selection.step, ", expected some of the take's ", count, " frames, counted from 0");
  }
  std::vector<std::size_t> indices;
  for (std::size_t i = selection.first; i <= last; i += selection.step) indices.push_back(i);
  return indices;
}

void for_each_frame(Take& take, const std::vector<std::size_t>& indices, int threads,
                    const FrameWork& frame_work, const Observer& observer) {
  for (std::size_t begin = 0; begin < indices.size(); begin += kFramesAtOnce) {
    const std::size_t count = std::min(kFramesAtOnce, indices.size() - begin);
    std::vector<TakeFrame> pictures;
    for (std::size_t i = 0; i < count; ++i) {
      pictures.push_back(take.read_frame(indices[begin + i], observer));
    }
    parallel_for(count, threads, [&](std::size_t i) { frame_work.work(begin + i, pictures[i]); });
    for (std::size_t i = begin; i < begin + count; ++i) frame_work.finish(i);
    observer.progress("hulls", begin + count, indices.size());
  }
}

}  // namespace tegata
