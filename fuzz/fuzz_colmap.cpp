// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as COLMAP's cameras.txt and images.txt, with a zero byte between them.
#include <tuple>

#include "reading.h"
#include "tegata/take/calibration_colmap.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tegata::ColmapText files;
  std::tie(files.cameras, files.images) = tegata::two_files(data, size);
  tegata::read_or_refuse([&] {
    const tegata::CameraRig rig = tegata::read_colmap(files, 1.0);
    tegata::check_rig(rig);
    tegata::require_usable(rig);
  });
  return 0;
}
