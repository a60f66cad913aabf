// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as the TOML of a hand's shape. A shape that is read makes a hand.
#include "memory_file.h"
#include "reading.h"
#include "tegata/take/hand_shape_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tegata::MemoryFile file(data, size);
  tegata::read_or_refuse([&] {
    const tegata::HandShapeFile hand = tegata::read_hand_shape(file.path());
    tegata::check_shape(tegata::shape_from_parameters(hand.parameters));
    if (hand.standard_deviations) {
      tegata::require((hand.standard_deviations->array() > 0.0).all(), "a hand of no variance");
    }
  });
  return 0;
}
