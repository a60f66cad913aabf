// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/leaf_components.h"

#include <algorithm>
#include <cstddef>

#include "tegata/hull/lattice_map.h"
#include "tegata/mesh/edge_sides.h"

namespace tegata {
namespace {

constexpr std::uint32_t kNoLeaf = ~0u;

// Whether the surface passes through the face of a leaf that looks down an axis.
bool crosses_lower_face(const OctreeLeaf& leaf, unsigned axis) {
  const unsigned a = 1u << (axis + 1) % 3, b = 1u << (axis + 2) % 3;
  const bool first = leaf.field[0] > 0.0f;
  return (leaf.field[a] > 0.0f) != first || (leaf.field[b] > 0.0f) != first ||
         (leaf.field[a | b] > 0.0f) != first;
}

}  // namespace

SparseField without_small_components(const SparseField& field, double fraction) {
  LatticeMap<std::uint32_t> leaf_at(kNoLeaf);
  for (std::uint32_t i = 0; i < field.leaves.size(); ++i) leaf_at[field.leaves[i].index] = i;
  DisjointSets pieces(field.leaves.size());
  for (std::uint32_t i = 0; i < field.leaves.size(); ++i) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (!crosses_lower_face(field.leaves[i], axis)) continue;
      LatticeIndex below = field.leaves[i].index;
      --below[axis];
      const std::uint32_t neighbour = leaf_at[below];
      if (neighbour != kNoLeaf) pieces.unite(i, neighbour);
    }
  }
  std::vector<std::uint32_t> size(field.leaves.size(), 0);  // by the piece's root
  for (std::uint32_t i = 0; i < field.leaves.size(); ++i) ++size[pieces.root(i)];
  const std::uint32_t largest = size.empty() ? 0 : *std::max_element(size.begin(), size.end());
  const double least = fraction * static_cast<double>(largest);

  SparseField large{
      .origin = field.origin, .cell_size = field.cell_size, .leaves = {}, .levels = field.levels};
  large.leaves.reserve(field.leaves.size());
  for (std::uint32_t i = 0; i < field.leaves.size(); ++i) {
    if (static_cast<double>(size[pieces.root(i)]) >= least) large.leaves.push_back(field.leaves[i]);
  }
  return large;
}

}  // namespace tegata
