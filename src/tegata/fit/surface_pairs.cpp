// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_pairs.h"

#include <cmath>

#include "tegata/fit/digit_sums.h"

namespace tegata {
namespace {

using Eigen::Vector3d;

Vector3d vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

JointMotion::Vec single(const Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
JointMotion::Turn turn_of(const SkinMotion::Bone& bone) {
  return {single(vector_of(bone.turn[0])), single(vector_of(bone.turn[1])),
          single(vector_of(bone.turn[2]))};
}
JointMotion joint_motion(const SkinMotion::Digit& digit, std::size_t joint,
                         const Vector3d& from_anchor) {
  const SkinMotion::Axis& axis = digit.axes[joint];
  const SkinMotion::Axis& first = digit.axes[joint == 1 ? 0 : joint];
  return {turn_of(digit.bones[joint]),
          turn_of(digit.bones[joint - 1]),
          {single(vector_of(first.direction)), single(vector_of(axis.direction))},
          single(from_anchor + vector_of(axis.center))};
}

Vector3d moved_by(const SkinMotion::Bone& bone, const std::array<double, 3>& rest) {
  const Vector3d p = vector_of(rest);
  return Vector3d(vector_of(bone.turn[0]).dot(p), vector_of(bone.turn[1]).dot(p),
                  vector_of(bone.turn[2]).dot(p)) +
         vector_of(bone.shift);
}

// Takes a pair into a lane.
void fill_lane(const SkinRows::HingedVertex& vertex, const SurfacePair& pair,
               const Vector3d& anchor, PairBlock& block, std::size_t lane) {
  const float root = std::sqrt(static_cast<float>(pair.weight));
  for (std::size_t k = 0; k < 3; ++k) {
    block.beyond[k][lane] = vertex.beyond[k];
    block.before[k][lane] = vertex.before[k];
    block.normal[k][lane] = root * static_cast<float>(pair.normal[static_cast<Eigen::Index>(k)]);
  }
  block.offset[lane] = root * static_cast<float>(pair.normal.dot(pair.point - anchor));
}

}  // namespace

SurfacePairs::SurfacePairs(const SkinRows& rows, std::span<const SurfacePair> pairs) {
  if (!pairs.empty()) anchor_ = pairs.front().point;
  std::array<std::size_t, kBoneCount + 1> next = {};  // first counts of pairs, then free lanes
  for (const SurfacePair& pair : pairs) ++next[rows.hinge(pair.vertex)];
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    first_[bone + 1] = first_[bone] + (next[bone] + kRowLanes - 1) / kRowLanes;
    next[bone] = first_[bone] * kRowLanes;
  }
  // Of memory only what no pair is written to is cleared.
  blocks_ = std::make_unique_for_overwrite<PairBlock[]>(first_.back());
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    if (first_[bone] < first_[bone + 1]) blocks_[first_[bone + 1] - 1] = {};
  }
  for (const SurfacePair& pair : pairs) {
    const std::size_t bone = rows.hinge(pair.vertex);
    if (bone == SkinRows::kNoBone) {
      add_tangled(rows, pair);
      continue;
    }
    const std::size_t at = next[bone]++;
    fill_lane(rows.hinged(pair.vertex), pair, anchor_, blocks_[at / kRowLanes], at % kRowLanes);
  }
}

void SurfacePairs::add_tangled(const SkinRows& rows, const SurfacePair& pair) {
  TangledPair& tangled = tangled_.emplace_back();
  tangled.pair = pair;
  const auto add_row = [&](std::size_t row) {
    const SkinRows::Block& block = rows.blocks()[row / kRowLanes];
    const std::size_t lane = row % kRowLanes, part = rows.part_of_row(row);
    for (std::size_t k = 0; k < 3; ++k) tangled.position[k] = block.position[k][lane];
    for (std::size_t i = 0; i < 4; ++i) {
      tangled.weights[i == 0 ? 0 : 3 * part + i] += block.weights[i][lane];
    }
  };
  const SkinRows::SharedVertex* const shared = rows.shared(pair.vertex);
  if (shared == nullptr) return add_row(rows.first_row(pair.vertex));
  for (const std::uint32_t row : shared->rows) add_row(row);
}

std::span<const PairBlock> SurfacePairs::blocks(std::size_t bone) const {
  return {blocks_.get() + first_[bone], first_[bone + 1] - first_[bone]};
}

double SurfacePairs::add_to(FrameEquations& equations, const SkinMotion& motion,
                            InstructionSet set) const {
  const Vector3d from_anchor = motion.origin() - anchor_;
  double cost = 0.0;
  if (!blocks(0).empty()) {
    PairSums<0> palm;
    sum_up<0>(blocks(0), {turn_of(motion.palm()), {}, {}, single(from_anchor)}, set, palm);
    cost += add_palm_sums(palm, equations);
  }
  if (first_[1] < first_[kBoneCount]) {
    std::array<DigitSums, kDigitCount> sums;
    for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
      const SkinMotion::Digit& moved = motion.digit(digit);
      const auto joint = [&](std::size_t i) { return joint_motion(moved, i, from_anchor); };
      sum_up<2>(blocks(3 * digit + 1), joint(1), set, sums[digit].first);
      sum_up<1>(blocks(3 * digit + 2), joint(2), set, sums[digit].others[0]);
      sum_up<1>(blocks(3 * digit + 3), joint(3), set, sums[digit].others[1]);
    }
    cost += add_digit_sums(sums, motion, set, equations);
  }
  for (const TangledPair& tangled : tangled_) cost += add_tangled_to(equations, motion, tangled);
  return cost;
}

// Bone by bone, in double precision.
double SurfacePairs::add_tangled_to(FrameEquations& equations, const SkinMotion& motion,
                                    const TangledPair& tangled) {
  const Vector3d& normal = tangled.pair.normal;
  Vector3d point = Vector3d::Zero();
  HandRow row;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const double weight = tangled.weights[bone];
    if (weight == 0.0) continue;
    const std::size_t digit = bone == 0 ? 0 : (bone - 1) / 3, joint = bone - 3 * digit;
    const Vector3d moved = weight * moved_by(motion.digit(digit).bones[joint], tangled.position);
    point += moved;
    if (bone == 0) continue;
    row.digits |= DigitSet{1} << digit;
    for (std::size_t angle = 0; angle <= joint; ++angle) {
      const SkinMotion::Axis& axis = motion.digit(digit).axes[angle];
      const Vector3d arm = moved - weight * vector_of(axis.center);
      row.values[kPoseParameterCount +
                 static_cast<Eigen::Index>(kAnglesPerDigit * digit + angle)] +=
          vector_of(axis.direction).dot(arm.cross(normal));
    }
  }
  row.values.head<3>() = point.cross(normal).transpose();
  row.values.segment<3>(3) = normal.transpose();
  const double residual = normal.dot(point + motion.origin() - tangled.pair.point);
  equations.add(residual, row, tangled.pair.weight, 0.0);
  return 0.5 * tangled.pair.weight * residual * residual;
}

}  // namespace tegata
