// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/block_sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tegata/base/random.h"
#include "tegata/image/distance_transform.h"

namespace tegata {
namespace {

constexpr std::size_t kPoints = SilhouetteBlock::kPoints;
constexpr float kLargest = 4.0f;  // distance [px]

// A view from somewhere around the lattice's first 64 cells, with ragged distances and unknowns.
struct RandomView {
  SampledView view;
  Image<float> distance;
};
RandomView random_view(Random& random) {
  RandomView made;
  SampledView& view = made.view;
  const auto between = [&](double low, double high) {
    return static_cast<float>(random.uniform(low, high));
  };
  view.width = 120.0f;
  view.height = 90.0f;
  view.metres_per_pixel = 0.002f;
  view.left = 10.0f;
  view.top = 5.0f;
  view.origin = {between(0.0, 60.0), between(0.0, 50.0), between(-0.2, 1.0)};
  for (auto& step : view.steps) {
    step = {between(-0.8, 0.8), between(-0.8, 0.8), between(-0.01, 0.01)};
  }
  made.distance = Image<float>(80, 70);
  for (float& value : made.distance.values()) value = between(-3.0, 4.0);
  view.distance = packed_pairs(made.distance, kLargest);
  view.distance_step = packing_step(kLargest);
  if (random.index(2) == 0) {
    view.unknown = Image<float>(80, 70, 0.0f);
    for (float& value : view.unknown.values()) value = random.index(4) == 0 ? 1.0f : 0.0f;
  }
  return made;
}

struct PlainSample {
  double field = 0.0;
  bool unproven = false;
};

// By the definition, one point at a time.
PlainSample plain_sample(const std::vector<RandomView>& views, const SamplingRule& rule,
                         const LatticeIndex& point) {
  std::vector<double> fields;
  std::size_t against = 0;
  ViewSet seeing = 0;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const SampledView& view = views[v].view;
    const Image<float>& distance = views[v].distance;
    double h[3];
    for (std::size_t i = 0; i < 3; ++i) {
      h[i] = static_cast<double>(view.origin[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        h[i] += point[axis] * static_cast<double>(view.steps[axis][i]);
      }
    }
    const double x = h[0] / h[2], y = h[1] / h[2];
    const double width = static_cast<double>(view.width), height = static_cast<double>(view.height);
    if (!(h[2] > 0.0 && x >= -0.5 && y >= -0.5 && x < width - 0.5 && y < height - 0.5)) continue;
    seeing |= ViewSet{1} << v;
    const double local_x = x - static_cast<double>(view.left);
    const double local_y = y - static_cast<double>(view.top);
    double pixels = static_cast<double>(sample_bilinear(distance, local_x, local_y));
    if (pixels <= 0.0) {
      pixels -= std::max({0.0, -local_x, local_x - (distance.width() - 1)}) +
                std::max({0.0, -local_y, local_y - (distance.height() - 1)});
    }
    const int column = static_cast<int>(std::floor(local_x + 0.5));
    const int row = static_cast<int>(std::floor(local_y + 0.5));
    const bool is_unknown =
        !view.unknown.empty() && view.unknown(std::clamp(column, 0, view.unknown.width() - 1),
                                              std::clamp(row, 0, view.unknown.height() - 1)) > 0.0f;
    against += is_unknown || pixels <= 0.0 ? 1 : 0;
    fields.push_back(pixels * h[2] * static_cast<double>(view.metres_per_pixel));
  }
  if (!rule.suffices(seeing)) return {static_cast<double>(rule.outside_value), true};
  std::sort(fields.begin(), fields.end());
  const double field = fields[rule.dissenting_views];
  return {field, field > 0.0 && against > rule.dissenting_views};
}

TEST(BlockSampling, ManyViewsSufficeOrFewThatLookAcrossEachOther) {
  SamplingRule rule;
  rule.least_views = 3;
  rule.across = {0b0010, 0b0001, 0b0000, 0b0000};  // only the first two
  EXPECT_TRUE(rule.suffices(0b0011));
  EXPECT_TRUE(rule.suffices(0b1101));
  EXPECT_FALSE(rule.suffices(0b0101));
  EXPECT_FALSE(rule.suffices(0b0001));
  rule.least_across = 3;
  EXPECT_FALSE(rule.suffices(0b0011));
  EXPECT_TRUE(rule.suffices(0b0111));
}

TEST(BlockSampling, ViewsThatAreCertainOrSeeAllNeedNotBeAsked) {
  Random random(12);
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<SampledView> views;
    for (int i = 0; i < 4; ++i) views.push_back(random_view(random).view);
    // The second sees the whole block, and nowhere less than 3 pixels inside.
    views[1].origin = {20.0f, 20.0f, 1.0f};
    views[1].steps = {{{0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}, {0.1f, 0.1f, 0.0f}}};
    views[1].unknown = {};
    Image<float> deep(80, 70);
    for (float& value : deep.values()) value = static_cast<float>(random.uniform(3.0, 4.0));
    views[1].distance = packed_pairs(deep, kLargest);
    SamplingRule rule;
    rule.largest_value = 0.005f;
    rule.dissenting_views = random.index(2);
    const LatticeIndex low = {static_cast<std::int32_t>(4 * random.index(8)),
                              static_cast<std::int32_t>(4 * random.index(8)),
                              static_cast<std::int32_t>(4 * random.index(8))};
    SilhouetteBlock asked, spared;
    sample_block(views, rule, {}, low, best_instruction_set(), asked);
    sample_block(views, rule, {.certain = 0b0010}, low, best_instruction_set(), spared);
    SilhouetteBlock unasked;
    sample_block(views, rule, {.whole = 0b0010}, low, best_instruction_set(), unasked);
    for (std::size_t i = 0; i < kPoints; ++i) {
      ASSERT_EQ(asked.field[i], spared.field[i]);
      ASSERT_EQ(asked.unproven[i], spared.unproven[i]);
      ASSERT_EQ(asked.field[i], unasked.field[i]);
      ASSERT_EQ(asked.unproven[i], unasked.unproven[i]);
      ASSERT_LE(asked.field[i], rule.largest_value);
    }
  }
}

TEST(BlockSampling, EveryInstructionSetGivesTheSameBitsAndThePlainAnswer) {
  Random random(11);
  std::size_t inside = 0, outside = 0, unseen = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const std::size_t view_count = 2 + random.index(6);
    std::vector<RandomView> sources;
    std::vector<SampledView> views;
    for (std::size_t i = 0; i < view_count; ++i) {
      sources.push_back(random_view(random));
      views.push_back(sources.back().view);
    }
    SamplingRule rule;
    rule.least_views = 1 + random.index(view_count);
    rule.outside_value = -0.5f;
    SamplingRule lenient = rule;
    lenient.dissenting_views = random.index(rule.least_views);
    for (std::size_t i = 0; i < view_count; ++i) {
      rule.across.push_back(static_cast<ViewSet>(random.index(std::uint64_t{1} << view_count)));
    }
    const LatticeIndex low = {static_cast<std::int32_t>(4 * random.index(16)),
                              static_cast<std::int32_t>(4 * random.index(16)),
                              static_cast<std::int32_t>(4 * random.index(16))};
    for (const SamplingRule& asked : {rule, lenient}) {
      SilhouetteBlock block;
      sample_block(views, asked, {}, low, InstructionSet::baseline, block);
      for (const InstructionSet set : kInstructionSets) {
        if (!is_supported(set)) continue;
        SilhouetteBlock fast;
        sample_block(views, asked, {}, low, set, fast);
        for (std::size_t i = 0; i < kPoints; ++i) {
          ASSERT_EQ(fast.field[i], block.field[i]) << instruction_set_name(set);
          ASSERT_EQ(fast.unproven[i], block.unproven[i]) << instruction_set_name(set);
        }
      }
      std::size_t wrong = 0;  // by rounding, where a point falls between two pixels
      const bool has_leaves = std::any_of(block.field.begin(), block.field.begin() + kPoints,
                                          [](float field) { return field > 0.0f; });
      for (std::size_t i = 0; i < kPoints; ++i) {
        const auto at = static_cast<std::int32_t>(i);
        const PlainSample plain =
            plain_sample(sources, asked, {low[0] + at % 5, low[1] + at / 5 % 5, low[2] + at / 25});
        const double field = static_cast<double>(block.field[i]);
        const bool agrees =
            has_leaves ? std::abs(field - plain.field) < 1e-4 * (1.0 + std::abs(plain.field)) &&
                             (block.unproven[i] != 0) == plain.unproven
                       : plain.field <= 0.0;
        const bool is_unseen = plain.field == -0.5;
        wrong += agrees ? 0 : 1;
        (is_unseen ? unseen : plain.field > 0.0 ? inside : outside) += 1;
      }
      ASSERT_LE(wrong, 1u) << "scene " << scene;
    }
  }
  EXPECT_GT(inside, 1000u);
  EXPECT_GT(outside, 1000u);
  EXPECT_GT(unseen, 1000u);
}

}  // namespace
}  // namespace tegata
