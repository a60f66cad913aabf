// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a PNG, JPEG or TIFF. A picture that is read has pixels and is a mask, if need be.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/picture_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] {
    const tegata::CameraImage picture = tegata::read_picture(file.path());
    tegata::require(!picture.values.empty(), "a picture without pixels");
    tegata::require(picture.bits == 8 || picture.bits == 16, "a picture of other bits");
    tegata::silhouette_from_mask(picture);
  });
  return 0;
}
