// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/marching_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <sstream>
#include <string>

#include "tegata/base/random.h"

namespace tegata {
namespace {

// A small dense lattice of values; all corners beyond it are outside.
struct DenseField {
  int size = 4;  // corners a side
  std::vector<float> values;

  float at(int x, int y, int z) const {
    if (std::min({x, y, z}) < 0 || std::max({x, y, z}) >= size) return -1.0f;
    return values[static_cast<std::size_t>((z * size + y) * size + x)];
  }
  bool inside(int x, int y, int z) const { return at(x, y, z) > 0.0f; }

  SparseField sparse() const {
    SparseField field;
    field.origin = {0.3, -0.2, 0.1};
    field.cell_size = 0.5;
    for (int z = -1; z < size; ++z) {
      for (int y = -1; y < size; ++y) {
        for (int x = -1; x < size; ++x) {
          OctreeLeaf leaf{.index = {x, y, z}, .field = {}};
          int count = 0;
          for (int i = 0; i < 8; ++i) {
            const float value = at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
            leaf.field[static_cast<std::size_t>(i)] = value;
            count += value > 0.0f ? 1 : 0;
          }
          if (count > 0 && count < 8) field.leaves.push_back(leaf);
        }
      }
    }
    return field;
  }
};

// How many pieces the outside falls into within one cell: corners joined along edges, and across
// faces on which both diagonals are of one kind (there the inside corners are kept apart).
int outside_pieces(unsigned inside) {
  std::array<int, 8> root{};
  std::iota(root.begin(), root.end(), 0);
  const auto is_outside = [&](int corner) { return (inside >> corner & 1u) == 0; };
  const auto unite = [&](int a, int b) {
    const int from = root[static_cast<std::size_t>(a)], to = root[static_cast<std::size_t>(b)];
    std::replace(root.begin(), root.end(), from, to);
  };
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < a; ++b) {
      if (!is_outside(a) || !is_outside(b)) continue;
      const int difference = a ^ b;
      const bool edge = difference == 1 || difference == 2 || difference == 4;
      const bool diagonal = difference == 3 || difference == 5 || difference == 6;
      const int low_bit = difference & -difference;
      const bool ambiguous = diagonal && !is_outside(a ^ low_bit) && !is_outside(b ^ low_bit);
      if (edge || ambiguous) unite(a, b);
    }
  }
  int pieces = 0;
  for (int corner = 0; corner < 8; ++corner) {
    pieces += is_outside(corner) && root[static_cast<std::size_t>(corner)] == corner ? 1 : 0;
  }
  return pieces;
}

// Twice the Euler number of the solid, counted from the lattice alone: with compact support each
// inside corner counts 1, each inside edge -1, each inside face 1, each inside cell -1, and a mixed
// cell the number of pieces of the outside less one.
int expected_euler_number(const DenseField& f) {
  int solid = 0;
  for (int z = -1; z < f.size; ++z) {
    for (int y = -1; y < f.size; ++y) {
      for (int x = -1; x < f.size; ++x) {
        const auto in = [&](int dx, int dy, int dz) { return f.inside(x + dx, y + dy, z + dz); };
        const bool o = in(0, 0, 0), i = in(1, 0, 0), j = in(0, 1, 0), k = in(0, 0, 1);
        solid += (o ? 1 : 0) - (o && i ? 1 : 0) - (o && j ? 1 : 0) - (o && k ? 1 : 0);
        solid += (o && i && j && in(1, 1, 0) ? 1 : 0) + (o && j && k && in(0, 1, 1) ? 1 : 0) +
                 (o && i && k && in(1, 0, 1) ? 1 : 0);
        unsigned inside = 0;
        for (int c = 0; c < 8; ++c) inside |= (in(c & 1, c >> 1 & 1, c >> 2) ? 1u : 0u) << c;
        if (inside == 255) solid -= 1;
        if (inside != 0 && inside != 255) solid += outside_pieces(inside) - 1;
      }
    }
  }
  return 2 * solid;
}

void expect_sound(const DenseField& field, const std::string& name) {
  const TriangleMesh mesh = extract_isosurface(field.sparse());
  const MeshTopology topology = inspect_topology(mesh);
  ASSERT_TRUE(topology.closed) << name;
  ASSERT_TRUE(topology.oriented) << name;
  ASSERT_TRUE(topology.manifold) << name;
  ASSERT_EQ(topology.euler_number, expected_euler_number(field)) << name;
  ASSERT_EQ(mesh.normals.size(), mesh.vertices.size()) << name;
  for (const Eigen::Vector3d& normal : mesh.normals) ASSERT_TRUE(normal.allFinite()) << name;
  if (!mesh.triangles.empty()) {
    ASSERT_GT(enclosed_volume(mesh), 0.0) << name;
  }
}

TEST(MarchingCubes, EveryRandomFieldGivesAClosedOrientedManifoldOfTheRightGenus) {
  Random random(11);
  for (int round = 0; round < 10000; ++round) {
    DenseField field;
    const double threshold = random.uniform(-0.9, 0.9);
    for (int i = 0; i < 64; ++i) {
      field.values.push_back(static_cast<float>(random.uniform(-1.0, 1.0) + threshold));
    }
    expect_sound(field, "round " + std::to_string(round));
  }
}

TEST(MarchingCubes, EveryCellInEverySurroundingSignIsSound) {
  for (unsigned inside = 0; inside < 256; ++inside) {
    DenseField field{.size = 2, .values = {}};
    for (unsigned i = 0; i < 8; ++i) field.values.push_back((inside >> i & 1u) != 0 ? 1.0f : -1.0f);
    expect_sound(field, "case " + std::to_string(inside));
  }
}

TEST(MarchingCubes, ZerosInfinitiesAndNotNumbersMakeNoHolesAndNoWildVertices) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 6> choices = {0.0f, -0.0f, 1.0f, -kInfinity, kInfinity, kNotANumber};
  Random random(12);
  for (int round = 0; round < 500; ++round) {
    DenseField field;
    for (int i = 0; i < 64; ++i) field.values.push_back(choices[random.index(choices.size())]);
    expect_sound(field, "round " + std::to_string(round));
  }
}

TEST(MarchingCubes, RecordedCellsWithSingularFacesAreSound) {
  const auto file = std::filesystem::path(TEGATA_DATA_DIR) / "cube_cases" / "mc33_cells.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  std::ifstream stream(file);
  const std::string json{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  int count = 0;
  // The file is one object of lists of eight numbers.
  for (auto open = json.find('['); open != std::string::npos; open = json.find('[', open + 1)) {
    std::istringstream list(json.substr(open + 1, json.find(']', open) - open - 1));
    std::vector<float> values;
    for (std::string number; std::getline(list, number, ',');) values.push_back(std::stof(number));
    ASSERT_EQ(values.size(), 8u);
    for (const float sign : {1.0f, -1.0f}) {
      DenseField field{.size = 2, .values = {}};
      for (const float value : values) field.values.push_back(sign * value);
      expect_sound(field, "list " + std::to_string(count));
      ++count;
    }
  }
  EXPECT_GT(count, 80);
}

TriangleMesh ball_mesh(double radius, double cell_size, const Eigen::Vector3d& center) {
  const auto field = [=](const Eigen::Vector3d& point) { return radius - (point - center).norm(); };
  const FieldSource source = {.classify =
                                  [=](const Eigen::AlignedBox3d& cube) {
                                    const double reach = 0.5 * cube.diagonal().norm(),
                                                 middle = field(cube.center());
                                    if (middle > reach) return Occupancy::inside;
                                    return middle < -reach ? Occupancy::outside : Occupancy::mixed;
                                  },
                              .sample = [=](const Eigen::Vector3d& point,
                                            bool&) { return static_cast<float>(field(point)); }};
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius);
  return extract_isosurface(
      build_octree(Eigen::AlignedBox3d(center - reach, center + reach), cell_size, source));
}

TEST(MarchingCubes, ABallsVolumeAndAreaConvergeWithTheSquareOfTheCell) {
  constexpr double kRadius = 0.05;
  const double volume = 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius;
  const double area = 4.0 * std::numbers::pi * kRadius * kRadius;
  for (const double cell_size : {0.01, 0.005, 0.0025}) {
    const TriangleMesh mesh = ball_mesh(kRadius, cell_size, {0.5001, -0.3, 0.2});
    const double ratio = cell_size / kRadius;
    EXPECT_NEAR(enclosed_volume(mesh) / volume, 1.0, 0.75 * ratio * ratio);
    EXPECT_NEAR(surface_area(mesh) / area, 1.0, 0.75 * ratio * ratio);
    EXPECT_EQ(inspect_topology(mesh).euler_number, 2);
  }
}

TEST(MarchingCubes, NormalsOfABallPointFromItsCenter) {
  const Eigen::Vector3d center(0.5, -0.3, 0.2);
  const TriangleMesh mesh = ball_mesh(0.05, 0.003, center);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    ASSERT_GT(mesh.normals[v].dot((mesh.vertices[v] - center).normalized()), 0.999);
    ASSERT_NEAR(mesh.normals[v].norm(), 1.0, 1e-9);
  }
}

TEST(MarchingCubes, MarksVerticesOfUnprovenLeavesAlone) {
  DenseField dense{.size = 4, .values = std::vector<float>(64, 1.0f)};
  SparseField field = dense.sparse();
  EXPECT_TRUE(extract_isosurface(field).unproven.empty());
  for (OctreeLeaf& leaf : field.leaves) leaf.unproven = leaf.index[0] < 0;
  const TriangleMesh mesh = extract_isosurface(field);
  ASSERT_EQ(mesh.unproven.size(), mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const bool touches = mesh.vertices[v].x() <= field.origin.x() + 1e-9;
    EXPECT_EQ(mesh.unproven[v] != 0, touches);
  }
}

TEST(MarchingCubes, AFieldWithoutLeavesIsAnEmptyMesh) {
  EXPECT_TRUE(extract_isosurface(SparseField{}).triangles.empty());
}

}  // namespace
}  // namespace tegata
