// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "tegata/hull/silhouette_field.h"

namespace tegata {

/// find_region() of visual_hull.h, on tables that are already made.
Eigen::AlignedBox3d locate_region(const SilhouetteField& field);

}  // namespace tegata
