// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tegata/hand/hand_model.h"
#include "tegata/hand/hand_shape.h"

namespace tegata {

struct BuiltInHandOptions {
  double cell_size = 0.0025;  ///< of the octree that the solid is meshed on [m]
  std::size_t triangle_count = 3000;
};

/// The project's own hand: a smooth solid of rounded cones around the bones, meshed by the octree
/// and marching cubes, each vertex linked to its nearest and second nearest bone (the paper,
/// III-B-2; skin_links.h). The thumb's flexion axes are turned so that the thumb opposes; a middle
/// finger's abduction is positive towards the index finger. Same shape and options give the same
/// hand to the bit.
HandModel built_in_hand(const HandShape& shape, Side side, const BuiltInHandOptions& options = {});

}  // namespace tegata
