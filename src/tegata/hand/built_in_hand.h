// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/hand/hand_model.h"
#include "tegata/hand/hand_shape.h"
#include "tegata/hand/shaped_hand.h"

namespace tegata {

/// The project's own hand: a smooth solid of rounded cones around the bones, meshed by the octree
/// and marching cubes, each vertex linked to its nearest and second nearest bone (the paper,
/// III-B-2; skin_links.h). The thumb's flexion axes are turned so that the thumb opposes; a middle
/// finger's abduction is positive towards the index finger. Same shape and options give the same
/// hand to the bit. For many shapes make a ShapedHand once.
HandModel built_in_hand(const HandShape& shape, Side side, const BuiltInHandOptions& options = {});

}  // namespace tegata
