// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/block_sampling.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace tegata {
namespace {

constexpr std::size_t kLanes = SilhouetteBlock::kLanes;
constexpr float kNobody = std::numeric_limits<float>::infinity();

using Lanes = std::array<float, kLanes>;
using ViewSets = std::array<std::int32_t, kLanes>;
using Indices = std::array<std::int32_t, kLanes>;
using Pairs = std::array<std::uint32_t, kLanes>;

// Compilers do not make look-ups by vector of a loop unless told for which machine.
struct PlainGather {
  static void look_up(const std::uint32_t* from, const Indices& at, Pairs& found) {
    for (std::size_t i = 0; i < kLanes; ++i) found[i] = from[at[i]];
  }
};
#if defined(__x86_64__)
struct VectorGather {
  TEGATA_AVX2 static void look_up(const std::uint32_t* from, const Indices& at, Pairs& found) {
    for (std::size_t i = 0; i < kLanes; i += 8) {
      const __m256i index = _mm256_load_si256(reinterpret_cast<const __m256i*>(&at[i]));
      _mm256_store_si256(reinterpret_cast<__m256i*>(&found[i]),
                         _mm256_i32gather_epi32(reinterpret_cast<const int*>(from), index, 4));
    }
  }
};
#else
using VectorGather = PlainGather;
#endif

// Lattice points of the block, by lane; those past the last repeat the first.
struct BlockPoints {
  alignas(64) Lanes x, y, z;
};

constexpr BlockPoints make_offsets() {
  BlockPoints offsets{};
  for (std::size_t i = 0; i < SilhouetteBlock::kPoints; ++i) {
    constexpr std::size_t kSide = SilhouetteBlock::kSide;
    offsets.x[i] = static_cast<float>(i % kSide);
    offsets.y[i] = static_cast<float>(i / kSide % kSide);
    offsets.z[i] = static_cast<float>(i / (kSide * kSide));
  }
  return offsets;
}
constexpr BlockPoints kOffsets = make_offsets();

// Where a view sees each point.
struct Projections {
  alignas(64) Lanes x, y;   // from the distance image's first pixel [px]
  alignas(64) Lanes depth;  // [m]
  alignas(64) Lanes seen;   // 1 or 0
};

// What it says of them.
struct Words {
  alignas(64) Lanes field;    // [m]; kNobody where the view does not see the point
  alignas(64) Lanes against;  // 1 where it does not see the hand itself there, else 0
};

// Whether the picture shows all points of the block: then none is asked whether it is seen.
enum class Sees { all, some };

// Conditions are numbers here and below: that is what compilers make vectors of.
TEGATA_KERNEL float one_if(bool condition) { return condition ? 1.0f : 0.0f; }

template <Sees kSees>
TEGATA_KERNEL void project(const SampledView& view, const BlockPoints& points,
                           Projections& projections) {
  const std::array<float, 3> o = view.origin, a = view.steps[0], b = view.steps[1],
                             c = view.steps[2];
  const float right = view.width - 0.5f, bottom = view.height - 0.5f;
  const float left = view.left, top = view.top, least_depth = view.least_depth;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float px = points.x[i], py = points.y[i], pz = points.z[i];
    const float depth = (o[2] + px * a[2]) + (py * b[2] + pz * c[2]);
    const float inverse = 1.0f / depth;
    const float x = ((o[0] + px * a[0]) + (py * b[0] + pz * c[0])) * inverse;
    const float y = ((o[1] + px * a[1]) + (py * b[1] + pz * c[1])) * inverse;
    projections.depth[i] = depth;
    projections.x[i] = x - left;
    projections.y[i] = y - top;
    if constexpr (kSees == Sees::some) {
      projections.seen[i] = one_if(depth > least_depth) * one_if(x >= -0.5f) * one_if(y >= -0.5f) *
                            one_if(x < right) * one_if(y < bottom);
    }
  }
}

// `value` limited to 0 .. last; 0 for what is not a number.
TEGATA_KERNEL float limited(float value, float last) {
  const float positive = value > 0.0f ? value : 0.0f;
  return positive < last ? positive : last;
}

// The halves of a packed pair.
TEGATA_KERNEL float left_of(std::uint32_t pair) {
  return static_cast<float>(static_cast<std::int32_t>(pair << 16) >> 16);
}
TEGATA_KERNEL float right_of(std::uint32_t pair) {
  return static_cast<float>(static_cast<std::int32_t>(pair) >> 16);
}

template <typename Gather, Sees kSees>
TEGATA_KERNEL void ask_view(const SampledView& view, const Projections& projections, Words& words) {
  const std::int32_t stride = view.distance.width(), last_row = view.distance.height() - 2;
  const float last_x = static_cast<float>(stride - 1), last_y = static_cast<float>(last_row + 1);
  const float metres_per_pixel = view.metres_per_pixel, step = view.distance_step;
  alignas(64) Indices at;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float in_x = limited(projections.x[i], last_x), in_y = limited(projections.y[i], last_y);
    const std::int32_t column = std::min(static_cast<std::int32_t>(in_x), stride - 2);
    const std::int32_t row = std::min(static_cast<std::int32_t>(in_y), last_row);
    at[i] = row * stride + column;
  }
  alignas(64) Pairs above_pairs, below_pairs;
  Gather::look_up(view.distance.values().data(), at, above_pairs);
  Gather::look_up(view.distance.values().data() + stride, at, below_pairs);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float x = projections.x[i], y = projections.y[i];
    const float in_x = limited(x, last_x), in_y = limited(y, last_y);
    const std::int32_t column = std::min(static_cast<std::int32_t>(in_x), stride - 2);
    const std::int32_t row = std::min(static_cast<std::int32_t>(in_y), last_row);
    const float u = in_x - static_cast<float>(column), v = in_y - static_cast<float>(row);
    const std::uint32_t above = above_pairs[i], below = below_pairs[i];
    const float upper = left_of(above) + u * (right_of(above) - left_of(above));
    const float lower = left_of(below) + u * (right_of(below) - left_of(below));
    const float within = step * (upper + v * (lower - upper));
    const float beyond = std::abs(x - in_x) + std::abs(y - in_y);
    const float pixels = within - (within > 0.0f ? 0.0f : beyond);
    words.field[i] = pixels * projections.depth[i] * metres_per_pixel;
  }
  if constexpr (kSees == Sees::some) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      words.field[i] = projections.seen[i] > 0.0f ? words.field[i] : kNobody;
    }
  }
}

// Where a view sees background or, where its nearest pixel is unknown, proves nothing.
TEGATA_KERNEL void speak_against(const SampledView& view, const Projections& projections,
                                 Words& words) {
  for (std::size_t i = 0; i < kLanes; ++i) words.against[i] = one_if(!(words.field[i] > 0.0f));
  if (view.unknown.empty()) return;
  const float* const unknown = view.unknown.values().data();
  const std::int32_t stride = view.unknown.width();
  const float last_x = static_cast<float>(stride - 1);
  const float last_y = static_cast<float>(view.unknown.height() - 1);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const auto column = static_cast<std::int32_t>(limited(projections.x[i] + 0.5f, last_x));
    const auto row = static_cast<std::int32_t>(limited(projections.y[i] + 0.5f, last_y));
    const float marked = words.field[i] < kNobody ? unknown[row * stride + column] : 0.0f;
    words.against[i] = std::max(words.against[i], marked);
  }
}

// Whether the views that see each point suffice, as SamplingRule::suffices says: 1 or 0.
TEGATA_KERNEL void judge_views(const SamplingRule& rule, const ViewSets& seeing,
                               const Lanes& seeing_count, Lanes& enough) {
  alignas(64) ViewSets see_across{};
  for (std::size_t view = 0; view < rule.across.size(); ++view) {
    const auto self = static_cast<std::int32_t>(ViewSet{1} << view);
    const auto across = static_cast<std::int32_t>(rule.across[view]);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::int32_t all = (seeing[i] & self) != 0 ? -1 : 0;
      see_across[i] |= seeing[i] & across & all;
    }
  }
  const float least = static_cast<float>(rule.least_views);
  const float least_across = static_cast<float>(rule.least_across);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float by_pair = one_if(see_across[i] != 0) * one_if(seeing_count[i] >= least_across);
    enough[i] = std::max(by_pair, one_if(seeing_count[i] >= least));
  }
}

// Raises the `kept` smallest values so far by those of one more view.
TEGATA_KERNEL void keep_smallest(std::array<Lanes, kMostDissentingViews + 1>& smallest,
                                 std::size_t kept, Lanes& fields) {
  for (std::size_t k = 0; k < kept; ++k) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float held = smallest[k][i], field = fields[i];
      smallest[k][i] = std::min(held, field);
      fields[i] = std::max(held, field);
    }
  }
}

TEGATA_KERNEL bool is_any_positive(const Lanes& values) {
  std::int32_t any = 0;
  for (std::size_t i = 0; i < kLanes; ++i) any |= values[i] > 0.0f ? 1 : 0;
  return any != 0;
}

template <typename Gather>
TEGATA_KERNEL void sample(const std::vector<SampledView>& views, const SamplingRule& rule,
                          const BlockKnowledge& known, const LatticeIndex& low,
                          SilhouetteBlock& block) {
  BlockPoints points;
  for (std::size_t i = 0; i < kLanes; ++i) {
    points.x[i] = static_cast<float>(low[0]) + kOffsets.x[i];
    points.y[i] = static_cast<float>(low[1]) + kOffsets.y[i];
    points.z[i] = static_cast<float>(low[2]) + kOffsets.z[i];
  }
  alignas(64) std::array<Lanes, kMostDissentingViews + 1> smallest;  // in rising order
  const std::size_t kept = rule.dissenting_views + 1;
  for (std::size_t k = 0; k < kept; ++k) smallest[k].fill(rule.largest_value);
  bool is_any_unknown = false;  // without any, what is inside has no more against it than may be
  for (const SampledView& view : views) is_any_unknown |= !view.unknown.empty();
  alignas(64) Lanes seeing_count, against{}, enough;
  alignas(64) ViewSets seeing;
  const ViewSet whole = known.certain | known.whole;
  seeing.fill(static_cast<std::int32_t>(whole));
  seeing_count.fill(static_cast<float>(std::popcount(whole)));
  Projections projections;
  Words words;
  for (std::size_t v = 0; v < views.size(); ++v) {
    if ((known.certain >> v & 1u) != 0) continue;
    const SampledView& view = views[v];
    if ((known.whole >> v & 1u) != 0) {
      project<Sees::all>(view, points, projections);
      ask_view<Gather, Sees::all>(view, projections, words);
    } else {
      project<Sees::some>(view, points, projections);
      ask_view<Gather, Sees::some>(view, projections, words);
      const auto self = static_cast<std::int32_t>(ViewSet{1} << v);
      for (std::size_t i = 0; i < kLanes; ++i) seeing_count[i] += projections.seen[i];
      for (std::size_t i = 0; i < kLanes; ++i) seeing[i] |= projections.seen[i] > 0.0f ? self : 0;
    }
    if (is_any_unknown) {
      speak_against(view, projections, words);
      for (std::size_t i = 0; i < kLanes; ++i) against[i] += words.against[i];
    }
    keep_smallest(smallest, kept, words.field);
    if (!is_any_positive(smallest[rule.dissenting_views])) break;  // what is outside stays so
  }
  judge_views(rule, seeing, seeing_count, enough);
  const float outside_value = rule.outside_value;
  const float dissenting = static_cast<float>(rule.dissenting_views);
  const Lanes& rank = smallest[rule.dissenting_views];
  for (std::size_t i = 0; i < kLanes; ++i) {
    block.field[i] = enough[i] > 0.0f ? rank[i] : outside_value;
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float kept_by_unknown = one_if(against[i] > dissenting) * one_if(rank[i] > 0.0f);
    block.unproven[i] = kept_by_unknown + (1.0f - enough[i]) > 0.0f ? 1 : 0;
  }
}

using Sample = void(const std::vector<SampledView>&, const SamplingRule&, const BlockKnowledge&,
                    const LatticeIndex&, SilhouetteBlock&);

void sample_baseline(const std::vector<SampledView>& views, const SamplingRule& rule,
                     const BlockKnowledge& known, const LatticeIndex& low, SilhouetteBlock& block) {
  sample<PlainGather>(views, rule, known, low, block);
}
TEGATA_AVX2 void sample_avx2(const std::vector<SampledView>& views, const SamplingRule& rule,
                             const BlockKnowledge& known, const LatticeIndex& low,
                             SilhouetteBlock& block) {
  sample<VectorGather>(views, rule, known, low, block);
}
TEGATA_AVX512 void sample_avx512(const std::vector<SampledView>& views, const SamplingRule& rule,
                                 const BlockKnowledge& known, const LatticeIndex& low,
                                 SilhouetteBlock& block) {
  sample<VectorGather>(views, rule, known, low, block);
}

}  // namespace

float packing_step(float largest) { return largest / std::numeric_limits<std::int16_t>::max(); }

Image<std::uint32_t> packed_pairs(const Image<float>& values, float largest) {
  const float steps = 1.0f / packing_step(largest);
  const auto packed = [steps](float value) {
    // Away from zero, so that no value changes its side.
    const float rounded = value * steps + (value < 0.0f ? -0.5f : 0.5f);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(rounded));
  };
  Image<std::uint32_t> pairs(values.width(), values.height());
  const int last = values.width() - 1;
  for (int y = 0; y < values.height(); ++y) {
    const float* row = &values(0, y);
    std::uint32_t* pair = &pairs(0, y);
    for (int x = 0; x < last; ++x) pair[x] = (packed(row[x]) & 0xFFFFu) | packed(row[x + 1]) << 16;
    pair[last] = (packed(row[last]) & 0xFFFFu) | packed(row[last]) << 16;
  }
  return pairs;
}

bool SamplingRule::suffices(ViewSet views) const {
  const auto count = static_cast<std::size_t>(std::popcount(views));
  if (count >= least_views) return true;
  if (count < least_across) return false;
  for (std::size_t view = 0; view < across.size(); ++view) {
    if ((views >> view & 1u) != 0 && (views & across[view]) != 0) return true;
  }
  return false;
}

void sample_block(const std::vector<SampledView>& views, const SamplingRule& rule,
                  const BlockKnowledge& known, const LatticeIndex& low, InstructionSet set,
                  SilhouetteBlock& block) {
  constexpr std::array<Sample*, 3> kSamples = {sample_baseline, sample_avx2, sample_avx512};
  kSamples[static_cast<std::size_t>(set)](views, rule, known, low, block);
}

}  // namespace tegata
