// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "tegata/hand/hand_model.h"

namespace tegata {

/// The sizes of a hand, all in metres. Defaults are those of the mean adult, from published
/// anthropometry (sources beside each number in built_in_hand.cpp).
struct HandShape {
  double length = 0.189;        ///< wrist crease to the tip of the middle finger
  double palm_breadth = 0.084;  ///< at the finger knuckles
  double palm_thickness = 0.028;
  double finger_thickness = 1.0;  ///< scales all digits' radii
  double forearm_length = 0.05;   ///< of the stump beyond the wrist
};

struct BuiltInHandOptions {
  double cell_size = 0.0025;  ///< of the octree that the solid is meshed on [m]
  std::size_t triangle_count = 3000;
};

/// The project's own hand: a smooth solid of rounded cones around the bones, meshed by the octree
/// and marching cubes, each vertex linked to its nearest and second nearest bone (the paper,
/// III-B-2). Same shape and options give the same hand to the bit.
HandModel built_in_hand(const HandShape& shape, Side side, const BuiltInHandOptions& options = {});

}  // namespace tegata
