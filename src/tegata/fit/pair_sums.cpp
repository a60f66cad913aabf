// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/pair_sums.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace tegata {
namespace {

using Lanes = PairBlock::Lanes;

using Vec = JointMotion::Vec;

TEGATA_KERNEL Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
TEGATA_KERNEL float dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
TEGATA_KERNEL Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

TEGATA_KERNEL Vec turned(const JointMotion::Turn& turn, const std::array<Lanes, 3>& points,
                         std::size_t i) {
  const Vec p = {points[0][i], points[1][i], points[2][i]};
  return {dot(turn[0], p), dot(turn[1], p), dot(turn[2], p)};
}

template <std::size_t kAngles>
inline constexpr std::size_t kColumns = 7 + kAngles;
template <std::size_t kAngles>
using Columns = std::array<Lanes, kColumns<kAngles>>;

template <std::size_t kAngles>
TEGATA_KERNEL void fill_columns(const JointMotion& motion, const PairBlock& block,
                                Columns<kAngles>& columns) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const Vec normal = {block.normal[0][i], block.normal[1][i], block.normal[2][i]};
    Vec point = turned(motion.beyond, block.beyond, i);
    if constexpr (kAngles > 0) {
      const Vec lever = cross(point, normal);
      columns[7][i] = dot(motion.axes[0], lever);
      if constexpr (kAngles > 1) columns[8][i] = dot(motion.axes[1], lever);
      point = point + turned(motion.before, block.before, i);
    }
    const Vec moment = cross(point, normal);
    columns[0][i] = moment.x;
    columns[1][i] = moment.y;
    columns[2][i] = moment.z;
    columns[3][i] = normal.x;
    columns[4][i] = normal.y;
    columns[5][i] = normal.z;
    columns[6][i] = dot(normal, point + motion.from_anchor) - block.offset[i];
  }
}

constexpr std::size_t row_of(std::size_t product) {
  std::size_t row = 0;
  while ((row + 1) * (row + 2) / 2 <= product) ++row;
  return row;
}
constexpr std::size_t column_of(std::size_t product) {
  return product - row_of(product) * (row_of(product) + 1) / 2;
}

// So many floats as a register has, as the compiler keeps no array in registers from block to
// block; and so many of them as there are registers for beside what is multiplied.
template <std::size_t kSize, std::size_t kCount>
struct Registers {
  using Vector [[gnu::vector_size(kSize * sizeof(float))]] = float;
  static constexpr std::size_t kFloats = kSize, kSums = kCount;
};

template <typename Vector>
TEGATA_KERNEL const Vector& vector(const float& first) {
  return *reinterpret_cast<const Vector*>(&first);
}

// Sums over blocks of the products from kFirst on, as many as there are registers for.
template <typename Set, std::size_t kFirst, std::size_t kAngles, std::size_t... kProduct>
TEGATA_KERNEL void add_some_products(std::span<const Columns<kAngles>> blocks,
                                     std::index_sequence<kProduct...>, Lanes* sums) {
  using Vector = typename Set::Vector;
  for (std::size_t lane = 0; lane < kRowLanes; lane += Set::kFloats) {
    Vector in_registers[] = {(static_cast<void>(kProduct), Vector{})...};
    for (const Columns<kAngles>& columns : blocks) {
      ((in_registers[kProduct] += vector<Vector>(columns[row_of(kFirst + kProduct)][lane]) *
                                  vector<Vector>(columns[column_of(kFirst + kProduct)][lane])),
       ...);
    }
    (std::copy_n(reinterpret_cast<const float*>(&in_registers[kProduct]), Set::kFloats,
                 &sums[kFirst + kProduct][lane]),
     ...);
  }
}

template <typename Set, std::size_t kFirst, std::size_t kAngles>
TEGATA_KERNEL void add_products(std::span<const Columns<kAngles>> blocks, Lanes* sums) {
  constexpr std::size_t kLast = kPairProducts<kAngles>;
  constexpr std::size_t kNext = std::min(kFirst + Set::kSums, kLast);
  add_some_products<Set, kFirst, kAngles>(blocks, std::make_index_sequence<kNext - kFirst>(), sums);
  if constexpr (kNext < kLast) add_products<Set, kNext, kAngles>(blocks, sums);
}

// Of two vectors with a segment of so many lanes for each product half as many lanes for each of
// both: far halves of a segment are added to each other, of four lanes and fewer each to its
// neighbour.
template <std::size_t kSegment, typename Vector, int... kLane>
TEGATA_KERNEL void fold(const Vector& a, const Vector& b, Vector& sum,
                        std::integer_sequence<int, kLane...>) {
  constexpr int kHalf = kSegment / 2;
  constexpr bool kFar = kSegment > 4;
  constexpr auto from = [](int lane, int of_two) {
    const int first = lane / kHalf * 2 * kHalf, within = lane % kHalf;
    return first + (kFar ? within + of_two * kHalf : 2 * within + of_two);
  };
  sum = __builtin_shufflevector(a, b, from(kLane, 0)...) +
        __builtin_shufflevector(a, b, from(kLane, 1)...);
}

// The sum of the lanes of each of as many vectors as they have lanes, in the first one.
template <std::size_t kSegment, std::size_t kFloats, typename Vector>
TEGATA_KERNEL void add_across(Vector* vectors) {
#pragma GCC unroll 8
  for (std::size_t i = 0; i < kSegment / 2; ++i) {
    fold<kSegment>(vectors[2 * i], vectors[2 * i + 1], vectors[i],
                   std::make_integer_sequence<int, static_cast<int>(kFloats)>());
  }
  if constexpr (kSegment > 2) add_across<kSegment / 2, kFloats>(vectors);
}

// By fours, but for the widest registers, which have instructions for any order of lanes. The order
// is that of all: lanes at a distance of 8, of 4, then neighbours.
template <typename Set, std::size_t kFirst, std::size_t kLanes, std::size_t kSums>
TEGATA_KERNEL void add_lanes(const std::array<Lanes, kLanes>& lanes, bool is_first,
                             std::array<double, kSums>& sums) {
  constexpr std::size_t kFloats = Set::kFloats == kRowLanes ? kRowLanes : 4;
  using Vector = typename Registers<kFloats, 0>::Vector;
  using Sums [[gnu::vector_size(kFloats * sizeof(double))]] = double;
  Vector vectors[kFloats];
#pragma GCC unroll 16
  for (std::size_t p = 0; p < kFloats; ++p) {
    const float* const of = lanes[std::min(kFirst + p, kLanes - 1)].data();
    if constexpr (kFloats == kRowLanes) {
      vectors[p] = vector<Vector>(of[0]);
    } else {
      vectors[p] = (vector<Vector>(of[0]) + vector<Vector>(of[8])) +
                   (vector<Vector>(of[4]) + vector<Vector>(of[12]));
    }
  }
  add_across<kFloats, kFloats>(vectors);
  Sums now = __builtin_convertvector(vectors[0], Sums);
  if (!is_first) {
    Sums before;
    std::memcpy(&before, &sums[kFirst], sizeof before);
    now += before;
  }
  std::memcpy(&sums[kFirst], &now, sizeof now);
  constexpr std::size_t kNext = kFirst + kFloats;
  if constexpr (kNext < kLanes) add_lanes<Set, kNext>(lanes, is_first, sums);
}

template <typename Set, std::size_t kAngles>
TEGATA_KERNEL void run(std::span<const PairBlock> blocks, const JointMotion& motion,
                       PairSums<kAngles>& sums) {
  constexpr std::size_t kBlocksAtOnce = 16;  // of which the columns stay in the nearest cache
  alignas(64) std::array<Columns<kAngles>, kBlocksAtOnce> columns;
  alignas(64) std::array<Lanes, kPairProducts<kAngles>> lanes;
  if (blocks.empty()) sums.fill(0.0);
  for (std::size_t first = 0; first < blocks.size(); first += kBlocksAtOnce) {
    const std::size_t count = std::min(kBlocksAtOnce, blocks.size() - first);
    for (std::size_t b = 0; b < count; ++b) {
      fill_columns<kAngles>(motion, blocks[first + b], columns[b]);
    }
    add_products<Set, 0, kAngles>({columns.data(), count}, lanes.data());
    add_lanes<Set, 0>(lanes, first == 0, sums);
  }
}

template <std::size_t kAngles>
using Run = void(std::span<const PairBlock>, const JointMotion&, PairSums<kAngles>&);

template <std::size_t kAngles>
void run_baseline(std::span<const PairBlock> blocks, const JointMotion& motion,
                  PairSums<kAngles>& sums) {
  run<Registers<4, 12>, kAngles>(blocks, motion, sums);
}
template <std::size_t kAngles>
TEGATA_AVX2 void run_avx2(std::span<const PairBlock> blocks, const JointMotion& motion,
                          PairSums<kAngles>& sums) {
  run<Registers<8, 12>, kAngles>(blocks, motion, sums);
}
template <std::size_t kAngles>
TEGATA_AVX512 void run_avx512(std::span<const PairBlock> blocks, const JointMotion& motion,
                              PairSums<kAngles>& sums) {
  run<Registers<16, 28>, kAngles>(blocks, motion, sums);
}

}  // namespace

template <std::size_t kAngles>
void sum_up(std::span<const PairBlock> blocks, const JointMotion& motion, InstructionSet set,
            PairSums<kAngles>& sums) {
  constexpr std::array<Run<kAngles>*, 3> kRuns = {run_baseline<kAngles>, run_avx2<kAngles>,
                                                  run_avx512<kAngles>};
  kRuns[static_cast<std::size_t>(set)](blocks, motion, sums);
}

template void sum_up<0>(std::span<const PairBlock>, const JointMotion&, InstructionSet,
                        PairSums<0>&);
template void sum_up<1>(std::span<const PairBlock>, const JointMotion&, InstructionSet,
                        PairSums<1>&);
template void sum_up<2>(std::span<const PairBlock>, const JointMotion&, InstructionSet,
                        PairSums<2>&);

}  // namespace tegata
