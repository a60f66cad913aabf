// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_motion.h"

#include <algorithm>
#include <cmath>

namespace tegata {
namespace {

// b_from_a times a's bone.
SkinMotion::Bone moved(const Rigid3d& b_from_a, const SkinMotion::Bone& bone) {
  const Eigen::Matrix3d turn = b_from_a.rotation.toRotationMatrix();
  SkinMotion::Bone product;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double x = turn(row, 0), y = turn(row, 1), z = turn(row, 2);
    for (std::size_t k = 0; k < 3; ++k) {
      product.turn[i][k] = x * bone.turn[0][k] + y * bone.turn[1][k] + z * bone.turn[2][k];
    }
    product.shift[i] =
        x * bone.shift[0] + y * bone.shift[1] + z * bone.shift[2] + b_from_a.translation[row];
  }
  return product;
}

template <typename Number>
using Vec = std::array<Number, 3>;
template <typename Number>
using Rows = std::array<Vec<Number>, 3>;

using Lanes = SkinMotion::Lanes;
using LaneVec = SkinMotion::LaneVec;

struct Turns {
  alignas(64) std::array<Lanes, 4> sines, cosines;  // of the angles
};

// What a pose makes of some digits.
template <typename Number>
struct Moved {
  struct Bone {
    Rows<Number> turn;
    Vec<Number> shift;
  };
  std::array<Bone, 3> bones;
  std::array<Vec<Number>, 3> centers;
  std::array<Vec<Number>, 4> directions;
};

template <typename Number>
TEGATA_KERNEL const Number& load(const Lanes& lanes, std::size_t first) {
  return *reinterpret_cast<const Number*>(&lanes[first]);
}
template <typename Number>
TEGATA_KERNEL Vec<Number> load(const LaneVec& lanes, std::size_t first) {
  return {load<Number>(lanes[0], first), load<Number>(lanes[1], first),
          load<Number>(lanes[2], first)};
}

template <typename Number>
TEGATA_KERNEL Vec<Number> turned(const Rows<Number>& turn, const Vec<Number>& v) {
  Vec<Number> result;
#pragma GCC unroll 3
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = turn[i][0] * v[0] + turn[i][1] * v[1] + turn[i][2] * v[2];
  }
  return result;
}

// Turns a frame about an axis that is `local` in it; returns the axis as it lies in the world. What
// the frame's axes are along it the turn leaves alone, and that is `local` as well.
template <typename Number>
TEGATA_KERNEL Vec<Number> turn_about(const Vec<Number>& local, const Number& sine,
                                     const Number& cosine, Rows<Number>& turn) {
  const Vec<Number> d = turned(turn, local);
  const Number rest = 1.0 - cosine;
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec<Number> v = {turn[0][k], turn[1][k], turn[2][k]};
    const Number along = rest * local[k];
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
      turn[i][k] = cosine * v[i] + sine * (d[next] * v[last] - d[last] * v[next]) + along * d[i];
    }
  }
  return d;
}

template <typename Number>
TEGATA_KERNEL void move_digits(const SkinMotion::Joints& joints, const Turns& turns,
                               const Eigen::Matrix3d& palm, std::size_t first,
                               Moved<Number>& moved) {
  Rows<Number> turn;
  Vec<Number> shift = {};
#pragma GCC unroll 3
  for (std::size_t i = 0; i < 3; ++i) {
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
      turn[i][k] = Number{} + palm(static_cast<int>(i), static_cast<int>(k));
    }
  }
  const auto turn_by = [&](std::size_t angle) {
    moved.directions[angle] =
        turn_about(load<Number>(joints.axes[angle], first), load<Number>(turns.sines[angle], first),
                   load<Number>(turns.cosines[angle], first), turn);
  };
#pragma GCC unroll 3
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const Vec<Number> local = load<Number>(joints.centers[joint], first);
    Vec<Number>& center = moved.centers[joint];
    center = turned(turn, local);
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) center[i] += shift[i];
    if (joint == 0) turn_by(0);
    turn_by(joint + 1);
    const Vec<Number> from_origin = turned(turn, local);
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) shift[i] = center[i] - from_origin[i];

    const SkinMotion::Joints::Bone& from_rest = joints.bones[joint];
    const Rows<Number> rest = {load<Number>(from_rest.turn[0], first),
                               load<Number>(from_rest.turn[1], first),
                               load<Number>(from_rest.turn[2], first)};
    typename Moved<Number>::Bone& bone = moved.bones[joint];
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
#pragma GCC unroll 3
      for (std::size_t k = 0; k < 3; ++k) {
        bone.turn[i][k] =
            turn[i][0] * rest[0][k] + turn[i][1] * rest[1][k] + turn[i][2] * rest[2][k];
      }
    }
    bone.shift = turned(turn, load<Number>(from_rest.shift, first));
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) bone.shift[i] += shift[i];
  }
}

template <typename Number>
TEGATA_KERNEL std::array<double, 3> of_one(const Vec<Number>& v, std::size_t lane) {
  return {v[0][lane], v[1][lane], v[2][lane]};
}

template <typename Set>
TEGATA_KERNEL void run(const SkinMotion::Joints& joints, const Turns& turns,
                       const Eigen::Matrix3d& palm,
                       std::array<SkinMotion::Digit, kDigitCount>& digits) {
  for (std::size_t first = 0; first < kDigitCount; first += Set::kCount) {
    Moved<typename Set::Number> moved;
    move_digits(joints, turns, palm, first, moved);
    for (std::size_t i = 0; i < std::min<std::size_t>(Set::kCount, kDigitCount - first); ++i) {
      SkinMotion::Digit& digit = digits[first + i];
      for (std::size_t joint = 0; joint < 3; ++joint) {
        const auto& bone = moved.bones[joint];
        for (std::size_t row = 0; row < 3; ++row) {
          digit.bones[joint + 1].turn[row] = of_one(bone.turn[row], i);
        }
        digit.bones[joint + 1].shift = of_one(bone.shift, i);
        digit.axes[joint + 1] = {of_one(moved.centers[joint], i),
                                 of_one(moved.directions[joint + 1], i)};
      }
      digit.axes[0] = {digit.axes[1].center, of_one(moved.directions[0], i)};
    }
  }
}

using Run = void(const SkinMotion::Joints&, const Turns&, const Eigen::Matrix3d&,
                 std::array<SkinMotion::Digit, kDigitCount>&);
void run_baseline(const SkinMotion::Joints& joints, const Turns& turns, const Eigen::Matrix3d& palm,
                  std::array<SkinMotion::Digit, kDigitCount>& digits) {
  run<Digits<2>>(joints, turns, palm, digits);
}
TEGATA_AVX2 void run_avx2(const SkinMotion::Joints& joints, const Turns& turns,
                          const Eigen::Matrix3d& palm,
                          std::array<SkinMotion::Digit, kDigitCount>& digits) {
  run<Digits<4>>(joints, turns, palm, digits);
}
TEGATA_AVX512 void run_avx512(const SkinMotion::Joints& joints, const Turns& turns,
                              const Eigen::Matrix3d& palm,
                              std::array<SkinMotion::Digit, kDigitCount>& digits) {
  run<Digits<8>>(joints, turns, palm, digits);
}

}  // namespace

SkinMotion::SkinMotion(const HandModel& model) {
  constexpr Bone kNoMotion = {{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}, {}};
  const auto rest_from_zero = bone_transforms(model.skeleton, model.rest_angles);
  palm_from_rest_ = moved(rest_from_zero[0].inverse(), kNoMotion);
  for (std::size_t lane = 0; lane < Lanes().size(); ++lane) {
    const std::size_t digit = std::min<std::size_t>(lane, kDigitCount - 1);
    const auto set = [&](LaneVec& to, const auto& v) {
      for (std::size_t k = 0; k < 3; ++k) to[k][lane] = v[static_cast<int>(k)];
    };
    for (std::size_t i = 0; i < 4; ++i) set(joints_.axes[i], model.skeleton.axes[4 * digit + i]);
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const std::size_t bone = 3 * digit + 1 + joint;
      const int center = proximal_keypoint(static_cast<int>(bone));
      set(joints_.centers[joint], model.skeleton.keypoints[static_cast<std::size_t>(center)]);
      const Bone from_rest = moved(rest_from_zero[bone].inverse(), kNoMotion);
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
          joints_.bones[joint].turn[row][k][lane] = from_rest.turn[row][k];
        }
        joints_.bones[joint].shift[row][lane] = from_rest.shift[row];
      }
    }
  }
}

void SkinMotion::move_to(const HandPose& pose, InstructionSet set) {
  Turns turns;
  for (std::size_t lane = 0; lane < Lanes().size(); ++lane) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (lane < kDigitCount) {
        const double angle = pose.angles[static_cast<int>(4 * lane + i)];
        turns.sines[i][lane] = std::sin(angle);
        turns.cosines[i][lane] = std::cos(angle);
      } else {
        turns.sines[i][lane] = turns.sines[i][kDigitCount - 1];
        turns.cosines[i][lane] = turns.cosines[i][kDigitCount - 1];
      }
    }
  }
  const Rigid3d turn{pose.world_from_hand.rotation, Eigen::Vector3d::Zero()};
  constexpr std::array<Run*, 3> kRuns = {run_baseline, run_avx2, run_avx512};
  kRuns[static_cast<std::size_t>(set)](joints_, turns, turn.rotation.toRotationMatrix(), digits_);
  const Bone palm = moved(turn, palm_from_rest_);
  for (Digit& digit : digits_) digit.bones[0] = palm;
  origin_ = pose.world_from_hand.translation;
}

}  // namespace tegata
