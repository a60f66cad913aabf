// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as EasyMocap's intri.yml and extri.yml, with a zero byte between them, or as one file
// that is both.
#include "reading.h"
#include "tegata/take/calibration_easymocap.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto [first, second] = tegata::two_files(data, size);
  tegata::read_or_refuse([&, &first = first, &second = second] {
    const tegata::DataTree intrinsics = tegata::DataTree::parse(first, "intri.yml");
    const tegata::DataTree extrinsics =
        second.empty() ? intrinsics : tegata::DataTree::parse(second, "extri.yml");
    tegata::read_rigs_or_refuse([&](const tegata::CalibrationImportOptions& options) {
      return tegata::read_easymocap(intrinsics, extrinsics, options);
    });
  });
  return 0;
}
