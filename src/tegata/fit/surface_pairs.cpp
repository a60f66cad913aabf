// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Of a point p, about some centre, with a normal n the row s = (p x n, n) says how far a turn about
// the centre and a shift move p along n. An angle about an axis d through the centre that carries p
// as a whole moves it by d . (p x n). So a sum of s s^T holds all products of pose and angles of
// the points that it is taken of, and only joints that they are next to need columns of their own.
// The sums of a digit are gathered from its tip to the palm, as composite inertias are
// (Featherstone, Rigid Body Dynamics Algorithms, 2008, 6.2): at each joint they are taken to its
// centre.
#include "tegata/fit/surface_pairs.h"

#include <cmath>

namespace tegata {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

// What an angle or the residual has to do with turns and shifts: sum of it times s.
struct Wrench {
  Vector3d turn = Vector3d::Zero(), shift = Vector3d::Zero();

  // To a centre from which the old one is at c.
  void move_by(const Vector3d& c) { turn += c.cross(shift); }
};

// Sums over the points that joints so far carry.
struct Moments {
  Matrix3d turn = Matrix3d::Zero(), shift = Matrix3d::Zero();  // turn by turn, shift by shift
  Matrix3d cross = Matrix3d::Zero();                           // turn by shift
  Wrench residual;
  double squares = 0.0;  // of residuals

  // With t the moments and n the normals, t becomes t + c x n in sums of t t^T, t n^T and n n^T.
  void move_by(const Vector3d& c) {
    const Matrix3d before = cross;
    for (int i = 0; i < 3; ++i) cross.col(i) += c.cross(shift.col(i));
    for (int i = 0; i < 3; ++i) {
      const Vector3d from_before = c.cross(before.row(i)), from_after = c.cross(cross.row(i));
      turn.col(i) += from_before;
      turn.row(i) += from_after;
    }
    residual.move_by(c);
  }

  template <std::size_t kAngles>
  void add(const PairSums<kAngles>& sums) {
    const double* s = sums.data();
    Matrix3d t, n, c;
    t << s[0], s[1], s[3], s[1], s[2], s[4], s[3], s[4], s[5];
    n << s[9], s[13], s[18], s[13], s[14], s[19], s[18], s[19], s[20];
    c << s[6], s[10], s[15], s[7], s[11], s[16], s[8], s[12], s[17];
    turn += t;
    shift += n;
    cross += c;
    residual.turn += Vector3d(s[21], s[22], s[23]);
    residual.shift += Vector3d(s[24], s[25], s[26]);
    squares += s[27];
  }

  // What the pose has of them. Returns half the sum of the squared residuals.
  double add_to(FrameEquations& equations) const {
    equations.hessian.block<3, 3>(0, 0) += turn;
    equations.hessian.block<3, 3>(3, 0) += cross.transpose();
    equations.hessian.block<3, 3>(3, 3) += shift;
    equations.gradient.segment<3>(0) += residual.turn;
    equations.gradient.segment<3>(3) += residual.shift;
    return 0.5 * squares;
  }
};

// Of the joint's own angles in PairSums: products with turn, shift and residual, with the one
// before and with itself.
constexpr std::array<std::size_t, 2> kOwnProducts = {28, 36};

// Normal equations of a digit's pairs, gathered from its tip to the palm.
class DigitSum {
 public:
  explicit DigitSum(const SkinMotion::Digit& motion)
      : motion_(motion), center_(vector_of(motion.axes.back().center)) {}

  // Goes on to the next joint: its angles turn what is carried so far as a whole, and the pairs
  // next to it as its own columns say.
  template <std::size_t kAngles>
  void add_joint(std::size_t joint, const PairSums<kAngles>& sums) {
    const std::size_t first = joint + 1 - kAngles;
    move_to(vector_of(motion_.axes[joint].center));
    for (std::size_t i = 0; i < kAngles; ++i) {
      const std::size_t angle = first + i;
      const Vector3d direction = vector_of(motion_.axes[angle].direction);
      const double* own = sums.data() + kOwnProducts[i];
      angles_[angle].turn = carried_.turn * direction + Vector3d(own[0], own[1], own[2]);
      angles_[angle].shift =
          carried_.cross.transpose() * direction + Vector3d(own[3], own[4], own[5]);
      gradient_[at(angle)] = direction.dot(carried_.residual.turn) + own[6];
    }
    for (std::size_t i = 0; i < kAngles; ++i) {
      const std::size_t angle = first + i;
      const Vector3d direction = vector_of(motion_.axes[angle].direction);
      for (std::size_t k = 0; k <= i; ++k) {
        const Vector3d other = vector_of(motion_.axes[first + k].direction);
        hessian_(at(angle), at(first + k)) =
            direction.dot(carried_.turn * other) + sums[kOwnProducts[i] + 7 + k];
      }
      for (std::size_t outer = joint + 1; outer < kAnglesPerDigit; ++outer) {
        hessian_(at(outer), at(angle)) = direction.dot(angles_[outer].turn);
      }
    }
    carried_.add<kAngles>(sums);
  }

  // Adds all of it, about the hand's origin. Returns half the sum of the squared residuals.
  double add_to(std::size_t digit, FrameEquations& equations) {
    constexpr int kA = kAnglesPerDigit;
    move_to(Vector3d::Zero());
    const int first = kPoseParameterCount + kA * static_cast<int>(digit);
    equations.hessian.block<kA, kA>(first, first) += hessian_;
    equations.gradient.segment<kA>(first) += gradient_;
    for (int angle = 0; angle < kA; ++angle) {
      const Wrench& products = angles_[static_cast<std::size_t>(angle)];
      equations.hessian.block<1, 3>(first + angle, 0) += products.turn.transpose();
      equations.hessian.block<1, 3>(first + angle, 3) += products.shift.transpose();
    }
    return carried_.add_to(equations);
  }

 private:
  static Eigen::Index at(std::size_t angle) { return static_cast<Eigen::Index>(angle); }

  void move_to(const Vector3d& center) {
    const Vector3d to_old = center_ - center;
    carried_.move_by(to_old);
    for (Wrench& angle : angles_) angle.move_by(to_old);
    center_ = center;
  }

  const SkinMotion::Digit& motion_;
  Vector3d center_;  // that all sums are about
  Moments carried_;  // of the pairs beyond
  std::array<Wrench, kAnglesPerDigit> angles_ = {};
  Eigen::Matrix4d hessian_ = Eigen::Matrix4d::Zero();  // its lower half
  Eigen::Vector4d gradient_ = Eigen::Vector4d::Zero();
};

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
  double cost = add_palm_to(equations, motion, set);
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    cost += add_digit_to(equations, motion, digit, set);
  }
  for (const TangledPair& tangled : tangled_) cost += add_tangled_to(equations, motion, tangled);
  return cost;
}

double SurfacePairs::add_palm_to(FrameEquations& equations, const SkinMotion& motion,
                                 InstructionSet set) const {
  if (blocks(0).empty()) return 0.0;
  const Vector3d from_anchor = motion.origin() - anchor_;
  Moments moments;
  const JointMotion palm = {turn_of(motion.palm()), {}, {}, single(from_anchor)};
  moments.add<0>(pair_sums<0>(blocks(0), palm, set));
  return moments.add_to(equations);
}

double SurfacePairs::add_digit_to(FrameEquations& equations, const SkinMotion& motion,
                                  std::size_t digit, InstructionSet set) const {
  const std::size_t first_bone = 3 * digit + 1;
  if (first_[first_bone] == first_[first_bone + 3]) return 0.0;
  const SkinMotion::Digit& moved = motion.digit(digit);
  const Vector3d from_anchor = motion.origin() - anchor_;
  DigitSum sum(moved);
  for (std::size_t joint = 3; joint > 1; --joint) {
    sum.add_joint<1>(joint, pair_sums<1>(blocks(3 * digit + joint),
                                         joint_motion(moved, joint, from_anchor), set));
  }
  sum.add_joint<2>(1, pair_sums<2>(blocks(first_bone), joint_motion(moved, 1, from_anchor), set));
  return sum.add_to(digit, equations);
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
