// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a video. Each of its first pictures is read or refused.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/video_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMostPictures = 4;
  const tegata::MemoryFile bytes(data, size);
  tegata::read_or_refuse([&] {
    tegata::VideoFile video(bytes.path());
    for (std::size_t i = 0; i < std::min(video.frame_count(), kMostPictures); ++i) {
      tegata::read_or_refuse(
          [&] { tegata::require(!video.read(i).values.empty(), "a picture without pixels"); });
    }
  });
  return 0;
}
