// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/frame_selection.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

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

namespace {

// A few decoded frames, and what was noticed on the way, which is said when their turn comes.
struct DecodedFrames {
  std::vector<TakeFrame> frames;
  std::vector<std::string> warnings;
};

DecodedFrames decode(Take& take, const std::vector<std::size_t>& indices, std::size_t begin) {
  DecodedFrames decoded;
  Observer observer;
  observer.on_warning = [&](std::string_view warning) { decoded.warnings.emplace_back(warning); };
  const std::size_t end = std::min(begin + kFramesAtOnce, indices.size());
  for (std::size_t i = begin; i < end; ++i) {
    decoded.frames.push_back(take.read_frame(indices[i], observer));
  }
  return decoded;
}

}  // namespace

void for_each_frame(Take& take, const std::vector<std::size_t>& indices, int threads,
                    const FrameWork& frame_work, const Observer& observer) {
  DecodedFrames now = decode(take, indices, 0);
  for (std::size_t begin = 0; begin < indices.size(); begin += kFramesAtOnce) {
    for (const std::string& warning : now.warnings) observer.warn(warning);
    const std::size_t count = now.frames.size();
    DecodedFrames next;
    // The first body decodes what comes next while the others work.
    parallel_for(count + 1, threads, [&](std::size_t i) {
      if (i == 0) {
        next = decode(take, indices, begin + count);
      } else {
        frame_work.work(begin + i - 1, now.frames[i - 1]);
      }
    });
    for (std::size_t i = begin; i < begin + count; ++i) frame_work.finish(i);
    observer.progress(frame_work.stage, begin + count, indices.size());
    now = std::move(next);
  }
}

}  // namespace tegata
