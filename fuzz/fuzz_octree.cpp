// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any values on any small lattice, through the octree and marching cubes: the leaves must be the
// cells that the surface crosses, and the surface closed, oriented, 2-manifold and of the Euler
// number that follows from the lattice's signs.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "bytes.h"
#include "tegata/base/error.h"
#include "tegata/hull/marching_cubes.h"
#include "tegata/hull/octree.h"
#include "tegata/hull/octree_division.h"

namespace tegata {
namespace {

constexpr int kMostDepth = 3;  // 9 x 9 x 9 corners

/// The values at the corners of the octree's finest cells.
class Lattice {
 public:
  Lattice(const OctreeRoot& root, Bytes& bytes)
      : root_(root), side_(root.cells() + 1), exact_(bytes.byte() % 4 != 0) {
    const int used = 1 + bytes.index(side_);  // values repeat after so many a row
    std::vector<float> values(static_cast<std::size_t>(used * used * used));
    for (float& value : values) value = draw_value(bytes);
    for (int i = 0; i < side_ * side_ * side_; ++i) {
      const int x = i % side_ % used, y = i / side_ % side_ % used, z = i / side_ / side_ % used;
      values_.push_back(values[static_cast<std::size_t>(x + used * (y + used * z))]);
    }
  }

  FieldSource source() const {
    return {.classify = [this](const Eigen::AlignedBox3d& cube) { return classify(cube); },
            .sample =
                [this](const Eigen::Vector3d& point, bool& unproven) {
                  const LatticeIndex at = index_of(point);
                  unproven = is_unproven(at);
                  return value(at);
                }};
  }

  /// As the octree must take it: nothing is inside on the root's own faces.
  bool inside(int x, int y, int z) const {
    if (std::min({x, y, z}) <= 0 || std::max({x, y, z}) >= side_ - 1) return false;
    return value({x, y, z}) > 0.0f;
  }
  /// What the source says there.
  float value(const LatticeIndex& at) const {
    return values_[static_cast<std::size_t>(at[0] + side_ * (at[1] + side_ * at[2]))];
  }
  int cells() const { return side_ - 1; }
  static bool is_unproven(const LatticeIndex& at) { return (at[0] + at[1] + at[2]) % 3 == 0; }

 private:
  static float draw_value(Bytes& bytes) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr std::array<float, 12> kOdd = {0.0f,
                                            -0.0f,
                                            kInfinity,
                                            -kInfinity,
                                            std::numeric_limits<float>::quiet_NaN(),
                                            std::numeric_limits<float>::denorm_min(),
                                            -std::numeric_limits<float>::denorm_min(),
                                            std::numeric_limits<float>::max(),
                                            std::numeric_limits<float>::lowest(),
                                            std::numeric_limits<float>::min(),
                                            1.0f,
                                            -1.0f};
    const std::uint8_t byte = bytes.byte();
    if (byte < kOdd.size()) return kOdd[byte];
    return static_cast<float>(byte - 128) / 16.0f;
  }

  LatticeIndex index_of(const Eigen::Vector3d& point) const {
    LatticeIndex index;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const double place = (point[i] - root_.origin[i]) / root_.cell_size;
      index[axis] = static_cast<std::int32_t>(std::lround(place));
      require(index[axis] >= 0 && index[axis] < side_, "a point beyond the root cube is asked for");
    }
    return index;
  }

  /// As sharp as may be, or always in doubt.
  Occupancy classify(const Eigen::AlignedBox3d& cube) const {
    if (!exact_) return Occupancy::mixed;
    const LatticeIndex low = index_of(cube.min()), high = index_of(cube.max());
    bool all_inside = true, all_outside = true;
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int x = low[0]; x <= high[0]; ++x) {
          (value({x, y, z}) > 0.0f ? all_outside : all_inside) = false;
        }
      }
    }
    return all_inside ? Occupancy::inside : all_outside ? Occupancy::outside : Occupancy::mixed;
  }

  OctreeRoot root_;
  int side_;    // corners
  bool exact_;  // classify() decides what it can
  std::vector<float> values_;
};

/// The corners of a cell that are inside, bit i for corner i.
unsigned signs_of(const Lattice& lattice, int x, int y, int z) {
  unsigned signs = 0;
  for (int i = 0; i < 8; ++i) {
    signs |= (lattice.inside(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)) ? 1u : 0u) << i;
  }
  return signs;
}

/// How many pieces the outside of a cell falls into: outside corners hang together along edges, and
/// across a face whose other two corners are inside.
int outside_pieces(unsigned signs) {
  const auto outside = [&](int corner) { return (signs >> corner & 1u) == 0; };
  unsigned unseen = ~signs & 255u;
  int pieces = 0;
  for (; unseen != 0; ++pieces) {
    unsigned piece = unseen & (~unseen + 1);
    for (unsigned before = 0; before != piece;) {
      before = piece;
      for (int a = 0; a < 8; ++a) {
        if ((before >> a & 1u) == 0) continue;
        for (int axis = 0; axis < 3; ++axis) {
          const int b = a ^ (1 << axis), c = a ^ (1 << (axis + 1) % 3);
          const int across = b ^ c ^ a;
          if (outside(b)) piece |= 1u << b;
          if (!outside(b) && !outside(c) && outside(across)) piece |= 1u << across;
        }
      }
    }
    unseen &= ~piece;
  }
  return pieces;
}

struct Expected {
  std::size_t crossed_cells = 0;
  int euler_number = 0;
};

/// The solid is made of corners, edges, faces and cells that are inside, and of what fills crossed
/// cells; its surface has twice its Euler number.
Expected expected_of(const Lattice& lattice) {
  Expected expected;
  int solid = 0;
  for (int z = 0; z < lattice.cells(); ++z) {
    for (int y = 0; y < lattice.cells(); ++y) {
      for (int x = 0; x < lattice.cells(); ++x) {
        const unsigned signs = signs_of(lattice, x, y, z);
        const auto all = [&](unsigned corners) { return (signs & corners) == corners ? 1 : 0; };
        solid += all(1) - all(3) - all(5) - all(17) + all(15) + all(51) + all(85) - all(255);
        if (signs == 0 || signs == 255) continue;
        solid += outside_pieces(signs) - 1;
        ++expected.crossed_cells;
      }
    }
  }
  expected.euler_number = 2 * solid;
  return expected;
}

void check_leaves(const SparseField& field, const Lattice& lattice, const Expected& expected) {
  require(field.leaves.size() == expected.crossed_cells, "leaves are not the crossed cells");
  for (const OctreeLeaf& leaf : field.leaves) {
    const unsigned signs = signs_of(lattice, leaf.index[0], leaf.index[1], leaf.index[2]);
    bool must_be_marked = false, may_be_marked = false;
    for (std::int32_t i = 0; i < 8; ++i) {
      const bool inside = (signs >> i & 1u) != 0;
      require((leaf.field[static_cast<std::size_t>(i)] > 0.0f) == inside,
              "a leaf's corner has the wrong sign");
      const LatticeIndex corner = {leaf.index[0] + (i & 1), leaf.index[1] + (i >> 1 & 1),
                                   leaf.index[2] + (i >> 2)};
      if (!Lattice::is_unproven(corner)) continue;
      must_be_marked = must_be_marked || inside;
      // On the root's faces a corner is outside whatever the source says of it.
      may_be_marked = may_be_marked || lattice.value(corner) > 0.0f;
    }
    require(leaf.unproven || !must_be_marked, "a leaf is not marked");
    require(!leaf.unproven || may_be_marked, "a leaf is marked without a reason");
  }
}

void check_surface(const TriangleMesh& mesh, const SparseField& field, const Expected& expected) {
  check_mesh(mesh);
  const MeshTopology topology = inspect_topology(mesh);
  require(topology.closed, "the surface is not closed");
  require(topology.oriented, "the surface is not oriented");
  require(topology.manifold, "the surface is not 2-manifold");
  require(topology.euler_number == expected.euler_number, "the Euler number is wrong");
  require(mesh.triangles.empty() == field.leaves.empty(), "leaves without a surface");
  require(mesh.normals.size() == mesh.vertices.size(), "a vertex has no normal");
  for (const Eigen::Vector3d& normal : mesh.normals) {
    require(normal.allFinite(), "a normal is not finite");
  }
  if (!mesh.triangles.empty()) {
    TriangleMesh local = mesh;  // so that the volume does not drown in the place
    for (Eigen::Vector3d& vertex : local.vertices) {
      vertex = (vertex - field.origin) / field.cell_size;
    }
    require(enclosed_volume(local) > 0.0, "the surface is turned inside out");
  }
}

/// A size from 1e-6 to 1e3, or anything at all.
double draw_size(Bytes& bytes) {
  const std::uint8_t kind = bytes.byte();
  return kind < 8 ? bytes.any_number() : std::pow(10.0, kind % 9 - 6) * (1.5 + bytes.fraction());
}

void run(Bytes bytes) {
  const double cell_size = draw_size(bytes);
  Eigen::AlignedBox3d region;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double low = bytes.byte() < 4 ? bytes.any_number() : 100.0 * cell_size * bytes.fraction();
    region.min()[axis] = low;
    region.max()[axis] = low + cell_size * 6.0 * std::abs(bytes.fraction());
  }
  const OctreeRoot root = root_around(region, cell_size);
  // Of larger cubes and of cells that are lost in the rounding of their place nothing is promised.
  const double reach = root.origin.cwiseAbs().maxCoeff();
  if (root.depth > kMostDepth || !(cell_size > 1e-9 * reach) || cell_size < 1e-30) return;
  const Lattice lattice(root, bytes);
  const SparseField field = build_octree(region, cell_size, lattice.source());
  const Expected expected = expected_of(lattice);
  check_leaves(field, lattice, expected);
  check_surface(extract_isosurface(field), field, expected);
}

}  // namespace
}  // namespace tegata

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    tegata::run(tegata::Bytes(data, size));
  } catch (const tegata::Error&) {
    // A region or a size that makes no sense: said in one line.
  }
  return 0;
}
