// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A digit's angle about an axis d through c moves a vertex by d x a, where a is the sum over the
// bones that it turns of weight (point - c) (posed_rows.cpp). Along a normal n that is d . (a x n),
// so that the first two angles, which share c, share the product as well.
#include "tegata/fit/surface_pairs.h"

#include <algorithm>
#include <utility>

namespace tegata {
namespace {

using Lanes = SurfacePairs::Lanes;
using Block = SurfacePairs::Block;

constexpr std::size_t kPoseColumns = 6, kDigitColumns = 10;
// So many blocks are summed in single precision before the sums go on in double.
constexpr std::size_t kBlocksPerSum = 32;

template <typename Scalar>
struct Vec {
  Scalar x, y, z;
};
template <typename S>
TEGATA_KERNEL Vec<S> operator+(const Vec<S>& a, const Vec<S>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename S>
TEGATA_KERNEL Vec<S> operator*(S factor, const Vec<S>& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
template <typename S>
TEGATA_KERNEL S dot(const Vec<S>& a, const Vec<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename S>
TEGATA_KERNEL Vec<S> cross(const Vec<S>& a, const Vec<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// SkinMotion::Digit in a row's precision.
template <typename S>
struct Motion {
  struct Bone {
    Vec<S> x, y, z, shift;  // rows of the turn
  };
  std::array<Bone, 4> bones;
  std::array<Vec<S>, 4> centers, directions;
};

template <typename S>
Vec<S> vec(const std::array<double, 3>& v) {
  return {static_cast<S>(v[0]), static_cast<S>(v[1]), static_cast<S>(v[2])};
}
template <typename S>
Motion<S> motion_of(const SkinMotion::Digit& digit) {
  Motion<S> motion;
  for (std::size_t i = 0; i < 4; ++i) {
    const SkinMotion::Bone& bone = digit.bones[i];
    motion.bones[i] = {vec<S>(bone.turn[0]), vec<S>(bone.turn[1]), vec<S>(bone.turn[2]),
                       vec<S>(bone.shift)};
    motion.centers[i] = vec<S>(digit.axes[i].center);
    motion.directions[i] = vec<S>(digit.axes[i].direction);
  }
  return motion;
}

template <typename S>
TEGATA_KERNEL Vec<S> moved(const typename Motion<S>::Bone& bone, const Vec<S>& p) {
  return Vec<S>{dot(bone.x, p), dot(bone.y, p), dot(bone.z, p)} + bone.shift;
}
// The arm of a turn about `center` of points with a weight, along a normal.
template <typename S>
TEGATA_KERNEL Vec<S> lever(const Vec<S>& weighted, S weight, const Vec<S>& center,
                           const Vec<S>& normal) {
  const Vec<S> arm = {weighted.x - weight * center.x, weighted.y - weight * center.y,
                      weighted.z - weight * center.z};
  return cross(arm, normal);
}

// Where a digit's row is, about the hand's origin, and its four columns along a normal.
template <typename S>
struct DigitRow {
  Vec<S> point;
  S angles[4];
};
template <typename S>
TEGATA_KERNEL DigitRow<S> digit_row(const Motion<S>& motion, const Vec<S>& p,
                                    const std::array<S, 4>& w, const Vec<S>& normal) {
  const Vec<S> outer = w[3] * moved(motion.bones[3], p);
  const Vec<S> middle = w[2] * moved(motion.bones[2], p) + outer;
  const Vec<S> digit = w[1] * moved(motion.bones[1], p) + middle;
  const Vec<S> lever1 = lever(digit, w[1] + (w[2] + w[3]), motion.centers[1], normal);
  const Vec<S> lever2 = lever(middle, w[2] + w[3], motion.centers[2], normal);
  const Vec<S> lever3 = lever(outer, w[3], motion.centers[3], normal);
  return {w[0] * moved(motion.bones[0], p) + digit,
          {dot(motion.directions[0], lever1), dot(motion.directions[1], lever1),
           dot(motion.directions[2], lever2), dot(motion.directions[3], lever3)}};
}

// Columns of a block's rows, the residuals the last of them.
template <std::size_t kColumns>
using Columns = std::array<Lanes, kColumns + 1>;

TEGATA_KERNEL Vec<float> load(const std::array<Lanes, 3>& points, std::size_t i) {
  return {points[0][i], points[1][i], points[2][i]};
}

// The pose's columns of a row: the arm's product with the normal for a turn, the normal for a
// shift.
template <std::size_t kCount>
TEGATA_KERNEL void fill_pose_columns(const Vec<float>& point, const Vec<float>& n, std::size_t i,
                                     std::array<Lanes, kCount>& columns) {
  const Vec<float> turn = cross(point, n);
  columns[0][i] = turn.x;
  columns[1][i] = turn.y;
  columns[2][i] = turn.z;
  columns[3][i] = n.x;
  columns[4][i] = n.y;
  columns[5][i] = n.z;
}

TEGATA_KERNEL void fill_columns(const Motion<float>& motion, const Vec<float>& from_anchor,
                                const Block& block, Columns<kPoseColumns>& columns) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const Vec<float> n = load(block.normal, i);
    const Vec<float> point = moved(motion.bones[0], load(block.position, i));
    fill_pose_columns(point, n, i, columns);
    columns[6][i] = dot(n, point + from_anchor) - block.offset[i];
  }
}

TEGATA_KERNEL void fill_columns(const Motion<float>& motion, const Vec<float>& from_anchor,
                                const Block& block, Columns<kDigitColumns>& columns) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const Vec<float> n = load(block.normal, i);
    const std::array<float, 4> weights = {block.weights[0][i], block.weights[1][i],
                                          block.weights[2][i], block.weights[3][i]};
    const DigitRow<float> row = digit_row(motion, load(block.position, i), weights, n);
    fill_pose_columns(row.point, n, i, columns);
    columns[6][i] = row.angles[0];
    columns[7][i] = row.angles[1];
    columns[8][i] = row.angles[2];
    columns[9][i] = row.angles[3];
    columns[10][i] = dot(n, row.point + from_anchor) - block.offset[i];
  }
}

// Sums of products of columns, row by row of the lower half, lane by lane.
template <std::size_t kColumns>
inline constexpr std::size_t kProducts = (kColumns + 1) * (kColumns + 2) / 2;

constexpr std::size_t row_of(std::size_t product) {
  std::size_t row = 0;
  while ((row + 1) * (row + 2) / 2 <= product) ++row;
  return row;
}
constexpr std::size_t column_of(std::size_t product) {
  return product - row_of(product) * (row_of(product) + 1) / 2;
}

TEGATA_KERNEL void add_product(const Lanes& a, const Lanes& b, Lanes& sum) {
#pragma GCC unroll 1  // or it is gone before vectors are made of it
  for (std::size_t i = 0; i < kRowLanes; ++i) sum[i] += a[i] * b[i];
}

// One after the other, written out: loops over rows and columns would cost what the products do.
template <std::size_t kColumns, std::size_t... kProduct>
TEGATA_KERNEL void add_products(const Columns<kColumns>& columns, const Lanes& weight,
                                std::index_sequence<kProduct...>,
                                std::array<Lanes, kProducts<kColumns>>& products) {
  alignas(64) Columns<kColumns> weighted;
  for (std::size_t row = 0; row <= kColumns; ++row) {
    for (std::size_t i = 0; i < kRowLanes; ++i) weighted[row][i] = weight[i] * columns[row][i];
  }
  (add_product(weighted[row_of(kProduct)], columns[column_of(kProduct)], products[kProduct]), ...);
}

template <std::size_t kColumns>
TEGATA_KERNEL void add_lanes(const std::array<Lanes, kProducts<kColumns>>& products,
                             std::array<double, kProducts<kColumns>>& sums) {
  for (std::size_t p = 0; p < products.size(); ++p) {
    const Lanes& lanes = products[p];
    float eight[8], four[4];
    for (std::size_t i = 0; i < 8; ++i) eight[i] = lanes[i] + lanes[i + 8];
    for (std::size_t i = 0; i < 4; ++i) four[i] = eight[i] + eight[i + 4];
    sums[p] += static_cast<double>((four[0] + four[1]) + (four[2] + four[3]));
  }
}

struct Task {
  const Block* first;
  const Block* last;
  Motion<float> motion;
  Vec<float> from_anchor;  // to the hand's origin
};

template <std::size_t kColumns>
TEGATA_KERNEL void run(const Task& task, std::array<double, kProducts<kColumns>>& sums) {
  for (const Block* block = task.first; block != task.last;) {
    alignas(64) std::array<Lanes, kProducts<kColumns>> products = {};
    const Block* const last = block + std::min<std::ptrdiff_t>(kBlocksPerSum, task.last - block);
    for (; block != last; ++block) {
      alignas(64) Columns<kColumns> columns;
      fill_columns(task.motion, task.from_anchor, *block, columns);
      add_products<kColumns>(columns, block->weight,
                             std::make_index_sequence<kProducts<kColumns>>(), products);
    }
    add_lanes<kColumns>(products, sums);
  }
}

template <std::size_t kColumns>
using Sums = std::array<double, kProducts<kColumns>>;

template <std::size_t kColumns>
void run_baseline(const Task& task, Sums<kColumns>& sums) {
  run<kColumns>(task, sums);
}
template <std::size_t kColumns>
TEGATA_AVX2 void run_avx2(const Task& task, Sums<kColumns>& sums) {
  run<kColumns>(task, sums);
}
template <std::size_t kColumns>
TEGATA_AVX512 void run_avx512(const Task& task, Sums<kColumns>& sums) {
  run<kColumns>(task, sums);
}

// Adds a part's products where they belong. Returns half the sum of the squared residuals.
template <std::size_t kColumns>
double add_part(const Task& task, std::size_t part, InstructionSet set, FrameEquations& equations) {
  constexpr std::array<void (*)(const Task&, Sums<kColumns>&), 3> kRuns = {
      run_baseline<kColumns>, run_avx2<kColumns>, run_avx512<kColumns>};
  Sums<kColumns> sums = {};
  kRuns[static_cast<std::size_t>(set)](task, sums);
  const auto parameter = [&](std::size_t column) {
    return static_cast<Eigen::Index>(column < kPoseColumns ? column : column + 4 * part);
  };
  std::size_t product = 0;
  for (std::size_t row = 0; row < kColumns; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      equations.hessian(parameter(row), parameter(column)) += sums[product++];
    }
  }
  for (std::size_t column = 0; column < kColumns; ++column) {
    equations.gradient[parameter(column)] += sums[product++];
  }
  return 0.5 * sums[product];
}

constexpr std::uint8_t kNoPart = kDigitCount + 1;

// Takes a pair of a vertex that has one row only.
void fill_lane(const SkinRows& rows, const SurfacePair& pair, const Eigen::Vector3d& anchor,
               Block& block, std::size_t lane) {
  const std::size_t row = rows.first_row(pair.vertex);
  const SkinRows::Block& from = rows.blocks()[row / kRowLanes];
  for (std::size_t k = 0; k < 3; ++k) {
    block.position[k][lane] = static_cast<float>(from.position[k][row % kRowLanes]);
    block.normal[k][lane] = static_cast<float>(pair.normal[static_cast<Eigen::Index>(k)]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    block.weights[k][lane] = static_cast<float>(from.weights[k][row % kRowLanes]);
  }
  block.offset[lane] = static_cast<float>(pair.normal.dot(pair.point - anchor));
  block.weight[lane] = static_cast<float>(pair.weight);
}

}  // namespace

SurfacePairs::SurfacePairs(const SkinRows& rows, std::span<const SurfacePair> pairs) {
  if (!pairs.empty()) anchor_ = pairs.front().point;
  std::vector<std::uint8_t> part_of_pair(pairs.size());
  std::array<std::size_t, kDigitCount + 1> next = {};  // first counts of pairs, then free rows
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::uint32_t vertex = pairs[i].vertex;
    if (!rows.shared().empty()) {
      if (const SkinRows::SharedVertex* const shared = rows.shared(vertex)) {
        part_of_pair[i] = kNoPart;
        add_shared(rows, *shared, pairs[i]);
        continue;
      }
    }
    const std::size_t part = rows.part_of_row(rows.first_row(vertex));
    part_of_pair[i] = static_cast<std::uint8_t>(part);
    ++next[part];
  }

  std::size_t block_count = 0;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    parts_[part].first = block_count;
    block_count += (next[part] + kRowLanes - 1) / kRowLanes;
    parts_[part].last = block_count;
    next[part] = parts_[part].first * kRowLanes;
  }
  blocks_.resize(block_count);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (part_of_pair[i] == kNoPart) continue;
    const std::size_t at = next[part_of_pair[i]]++;
    fill_lane(rows, pairs[i], anchor_, blocks_[at / kRowLanes], at % kRowLanes);
  }
}

void SurfacePairs::add_shared(const SkinRows& rows, const SkinRows::SharedVertex& shared,
                              const SurfacePair& pair) {
  shared_.push_back({pair, {}});
  for (const std::uint32_t row : shared.rows) {
    const SkinRows::Block& block = rows.blocks()[row / kRowLanes];
    SharedRow one;
    one.part = rows.part_of_row(row);
    for (std::size_t k = 0; k < 3; ++k) one.position[k] = block.position[k][row % kRowLanes];
    for (std::size_t k = 0; k < 4; ++k) one.weights[k] = block.weights[k][row % kRowLanes];
    shared_.back().rows.push_back(one);
  }
}

double SurfacePairs::add_to(FrameEquations& equations, const SkinMotion& motion,
                            InstructionSet set) const {
  const Eigen::Vector3f from_anchor = (motion.origin() - anchor_).cast<float>();
  double cost = 0.0;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    if (parts_[part].first == parts_[part].last) continue;
    const bool is_palm = part == SkinRows::kPalmPart;
    const Task task{blocks_.data() + parts_[part].first,
                    blocks_.data() + parts_[part].last,
                    motion_of<float>(motion.digit(is_palm ? 0 : part)),
                    {from_anchor.x(), from_anchor.y(), from_anchor.z()}};
    cost += is_palm ? add_part<kPoseColumns>(task, part, set, equations)
                    : add_part<kDigitColumns>(task, part, set, equations);
  }
  for (const SharedPair& shared : shared_) cost += add_shared_to(equations, motion, shared);
  return cost;
}

double SurfacePairs::add_shared_to(FrameEquations& equations, const SkinMotion& motion,
                                   const SharedPair& shared) {
  const Eigen::Vector3d& n = shared.pair.normal;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  HandRow row;
  for (const SharedRow& one : shared.rows) {
    const DigitRow<double> found =
        digit_row(motion_of<double>(motion.digit(one.part)), vec<double>(one.position), one.weights,
                  {n.x(), n.y(), n.z()});
    point += Eigen::Vector3d(found.point.x, found.point.y, found.point.z);
    const auto first = kPoseParameterCount + kAnglesPerDigit * static_cast<int>(one.part);
    for (int k = 0; k < kAnglesPerDigit; ++k) row.values[first + k] = found.angles[k];
    row.digits |= DigitSet{1} << one.part;
  }
  row.values.head<3>() = point.cross(n).transpose();
  row.values.segment<3>(3) = n.transpose();
  const double residual = n.dot(point + motion.origin() - shared.pair.point);
  equations.add(residual, row, shared.pair.weight, 0.0);
  return 0.5 * shared.pair.weight * residual * residual;
}

}  // namespace tegata
