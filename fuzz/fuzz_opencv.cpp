// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as what OpenCV's FileStorage writes: XML, YAML or JSON, a map for each camera, or
// stereo's intrinsics and extrinsics with a zero byte between them.
#include "reading.h"
#include "tegata/take/calibration_opencv.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto [first, second] = tegata::two_files(data, size);
  tegata::read_or_refuse([&, &first = first, &second = second] {
    const tegata::DataTree tree = tegata::DataTree::parse(first, "intrinsics.yml");
    const bool stereo = tegata::is_opencv_stereo(tree);
    const tegata::DataTree other =
        second.empty() ? tree : tegata::DataTree::parse(second, "extrinsics.yml");
    tegata::read_rigs_or_refuse([&](const tegata::CalibrationImportOptions& options) {
      return stereo ? tegata::read_opencv_stereo(tree, other, options)
                    : tegata::read_opencv(tree, options);
    });
  });
  return 0;
}
