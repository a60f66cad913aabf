// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tegata/fit/fit_hand.h"
#include "tegata/fit/view.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// For each bone how much of its surface the views back up: the share of its vertices that, in
/// every view that shows the vertex, lie on (or within two pixels of) a hand pixel. 1 is seen and
/// explained, 0 hidden or contradicted; 0 as well where no view shows the vertex.
std::array<double, kBoneCount> bone_support(const FitHand& hand, const PosedHand& posed,
                                            const std::vector<FitView>& views);

/// Intersection over union of the posed hand's silhouette and the seen one, over what lies on the
/// finger side of the wrist: pixels nearer to the forearm's part of the picture than to the hand's
/// are left out, as are unknown pixels. 0 where nothing overlaps.
double silhouette_overlap(const FitHand& hand, const PosedHand& posed, const FitView& view);

/// With less overlap than this a view does not show the hand where it is posed: it was found in the
/// others alone.
inline constexpr double kLeastSeenOverlap = 0.1;

/// More of a seen hand beside the posed one than this [m] is as bad as this.
inline constexpr double kWhollyUncovered = 0.02;

/// How far the border of the seen hand lies outside the posed one [m]: the mean, over the border on
/// the finger side of the wrist, of the distance in the picture at the hand's depth, where it is
/// more than a pixel and up to kWhollyUncovered. Nothing that hides the hand makes it larger.
/// Nothing where no border is seen there or the view is along the forearm, which looks like hand.
std::optional<double> uncovered_distance(const FitHand& hand, const PosedHand& posed,
                                         const FitView& view);

}  // namespace tegata
