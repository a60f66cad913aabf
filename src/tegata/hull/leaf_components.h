// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/hull/octree.h"

namespace tegata {

/// The field without the leaves of small pieces of the surface: those with less than `fraction` of
/// the leaves of the largest. Leaves are of one piece where the surface passes through the face
/// between them, so that no piece is cut; pieces that meet in a leaf count as one. Order is kept.
SparseField without_small_components(const SparseField& field, double fraction);

}  // namespace tegata
