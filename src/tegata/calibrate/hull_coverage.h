// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tegata/hull/visual_hull.h"

namespace tegata {

/// For each view, the share of its hand pixels on whose ray some point lies before the foreground
/// of all other views that see it: how much of the silhouette the visual hull of all views covers.
/// On a sample of pixels and of depths, without carving.
std::vector<double> hull_coverage(const std::vector<HullView>& views);

}  // namespace tegata
