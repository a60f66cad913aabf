// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tegata/image/silhouette.h"

namespace tegata {

/// A closed line [px]; the last point is joined to the first.
using Outline = std::vector<Eigen::Vector2d>;

/// The borders of the hand's pixels, holes included, through the middles of the pixels' edges, each
/// reduced to the fewest points found (Ramer, Douglas and Peucker) from which none of them is
/// farther than `tolerance_px`. Borders of fewer than 12 pixel edges are left out as specks.
std::vector<Outline> trace_outlines(const Silhouette& silhouette, double tolerance_px);

}  // namespace tegata
