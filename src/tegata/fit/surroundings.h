// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/solver.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// The frames with what stands about the hand drawn into their views, for a hand that is nearly
/// where it is estimated to be: the forearm (FitView::forearm) and an object in the hand's frame,
/// which may be empty (FitView::hiding_depth).
std::vector<FitFrame> with_surroundings(const FitHand& hand,
                                        std::span<const FitFrame* const> frames,
                                        const HandEstimate& estimate, const TriangleMesh& object,
                                        int threads);

std::vector<const FitFrame*> pointers_to(const std::vector<FitFrame>& frames);

}  // namespace tegata
