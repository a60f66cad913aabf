// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/accessor.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <limits>

#include "tegata/base/error.h"

namespace tegata {
namespace {

TEST(Accessor, ReadsBackWhatWasAppended) {
  tinygltf::Model model;
  const int bytes = append_byte_quads(model, {1, 2, 3, 250});
  const int floats = append_floats(model, {1.5F, -2.0F, 0.25F, 8.0F, 1.0F, 2.0F}, 3, 0, true);
  const int indices = append_indices(model, {0, 70000, 5});
  EXPECT_EQ(read_accessor(model, bytes, 4, "bytes"), std::vector<double>({1, 2, 3, 250}));
  EXPECT_EQ(read_accessor(model, floats, 3, "floats"),
            std::vector<double>({1.5, -2.0, 0.25, 8.0, 1.0, 2.0}));
  EXPECT_EQ(read_accessor(model, indices, 1, "indices"), std::vector<double>({0, 70000, 5}));
}

TEST(Accessor, BoundsAreThoseOfEachComponent) {
  tinygltf::Model model;
  const int index = append_floats(model, {1.0F, -2.0F, 3.0F, 4.0F}, 2, 0, true);
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  EXPECT_EQ(accessor.minValues, std::vector<double>({1.0, -2.0}));
  EXPECT_EQ(accessor.maxValues, std::vector<double>({3.0, 4.0}));
}

TEST(Accessor, NormalisedIntegersAreFractions) {
  tinygltf::Model model;
  const int index = append_byte_quads(model, {0, 51, 102, 255});
  model.accessors[static_cast<std::size_t>(index)].normalized = true;
  const std::vector<double> read = read_accessor(model, index, 4, "weights");
  EXPECT_DOUBLE_EQ(read[1], 0.2);
  EXPECT_DOUBLE_EQ(read[3], 1.0);
}

TEST(Accessor, StepsOverInterleavedNumbers) {
  tinygltf::Model model;
  const int index = append_floats(model, {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}, 1, 0, false);
  model.bufferViews[0].byteStride = 8;
  model.accessors[static_cast<std::size_t>(index)].count = 3;
  EXPECT_EQ(read_accessor(model, index, 1, "numbers"), std::vector<double>({1.0, 3.0, 5.0}));
}

/// Three vectors of which a sparse part replaces the last; accessor 0.
tinygltf::Model sparse_model() {
  tinygltf::Model model;
  append_floats(model, {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F, 8.0F, 9.0F}, 3, 0, false);
  append_indices(model, {2});
  append_floats(model, {-1.0F, -2.0F, -3.0F}, 3, 0, false);
  auto& sparse = model.accessors[0].sparse;
  sparse.isSparse = true;
  sparse.count = 1;
  sparse.indices = {
      .byteOffset = 0, .bufferView = 1, .componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT};
  sparse.values = {.bufferView = 2, .byteOffset = 0};
  return model;
}

TEST(Accessor, SparseElementsReplaceThoseBelow) {
  EXPECT_EQ(read_accessor(sparse_model(), 0, 3, "numbers"),
            std::vector<double>({1, 2, 3, 4, 5, 6, -1, -2, -3}));
}

TEST(Accessor, SparseElementsWithNothingBelowStandAmongZeros) {
  tinygltf::Model model = sparse_model();
  model.accessors[0].bufferView = -1;
  EXPECT_EQ(read_accessor(model, 0, 3, "numbers"),
            std::vector<double>({0, 0, 0, 0, 0, 0, -1, -2, -3}));
}

TEST(Accessor, SparsePartsThatReachOutAreRefused) {
  const auto refuses = [](auto&& change) {
    tinygltf::Model model = sparse_model();
    change(model.accessors[0]);
    EXPECT_THROW(read_accessor(model, 0, 3, "numbers"), Error);
  };
  refuses([](tinygltf::Accessor& a) { a.sparse.count = 2; });
  refuses([](tinygltf::Accessor& a) { a.sparse.count = -1; });
  refuses([](tinygltf::Accessor& a) { a.sparse.count = 4; });
  refuses([](tinygltf::Accessor& a) { a.sparse.indices.bufferView = 9; });
  refuses([](tinygltf::Accessor& a) { a.sparse.indices.byteOffset = -4; });
  refuses([](tinygltf::Accessor& a) { a.sparse.values.byteOffset = 4; });
  refuses([](tinygltf::Accessor& a) { a.count = 2; });  // the index is 2
  refuses([](tinygltf::Accessor& a) { a.sparse.indices.componentType = 0; });
}

// 178,956,970 elements of 12 bytes are 2 GB.
TEST(Accessor, TwoGigabytesWithoutABufferAreNotMade) {
  tinygltf::Model model = sparse_model();
  model.accessors[0].bufferView = -1;
  model.accessors[0].count = 178'956'970;
  EXPECT_THROW(read_accessor(model, 0, 3, "numbers"), Error);
}

TEST(Accessor, RefusesToReadPastTheBuffer) {
  constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max();
  tinygltf::Model good;
  append_floats(good, {1.0F, 2.0F, 3.0F}, 3, 0, false);
  const auto refuses = [&](auto&& change) {
    tinygltf::Model model = good;
    change(model);
    EXPECT_THROW(read_accessor(model, 0, 3, "numbers"), Error);
  };
  refuses([](tinygltf::Model& m) { m.accessors[0].count = 2; });
  refuses([](tinygltf::Model& m) { m.accessors[0].count = kHuge; });
  refuses([](tinygltf::Model& m) { m.accessors[0].byteOffset = 4; });
  refuses([](tinygltf::Model& m) { m.accessors[0].byteOffset = kHuge; });
  refuses([](tinygltf::Model& m) { m.bufferViews[0].byteOffset = kHuge - 3; });
  refuses([](tinygltf::Model& m) { m.bufferViews[0].byteLength = kHuge; });
  refuses([](tinygltf::Model& m) { m.bufferViews[0].buffer = 1; });
  refuses([](tinygltf::Model& m) { m.accessors[0].bufferView = -1; });
  refuses([](tinygltf::Model& m) { m.accessors[0].type = TINYGLTF_TYPE_VEC2; });
  refuses([](tinygltf::Model& m) { m.accessors[0].componentType = 7; });
  EXPECT_THROW(read_accessor(good, 1, 3, "numbers"), Error);
  EXPECT_THROW(read_accessor(good, -1, 3, "numbers"), Error);
}

}  // namespace
}  // namespace tegata
