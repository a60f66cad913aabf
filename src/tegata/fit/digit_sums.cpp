// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Of a point p, about some centre, with a normal n the row s = (p x n, n) says how far a turn about
// the centre and a shift move p along n. An angle about an axis d through the centre that carries p
// as a whole moves it by d . (p x n). So a sum of s s^T holds all products of pose and angles of
// the points that it is taken of, and only joints that they are next to need columns of their own.
// The sums of a digit are gathered from its tip to the palm, as composite inertias are
// (Featherstone, Rigid Body Dynamics Algorithms, 2008, 6.2): at each joint they are taken to its
// centre. All digits have the same joints, and are gathered side by side.
#include "tegata/fit/digit_sums.h"

#include <algorithm>

namespace tegata {
namespace {

template <typename Number>
using Vec = std::array<Number, 3>;

template <typename Number>
TEGATA_KERNEL void add_dot(const Vec<Number>& a, const Vec<Number>& b, Number& sum) {
  sum += a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// One axis of a x b.
template <typename Number>
TEGATA_KERNEL void add_cross(const Vec<Number>& a, const Vec<Number>& b, std::size_t axis,
                             Number& sum) {
  const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
  sum += a[next] * b[last] - a[last] * b[next];
}

// Of products in PairSums.
constexpr std::size_t place(std::size_t row, std::size_t column) {
  return row < column ? place(column, row) : row * (row + 1) / 2 + column;
}
constexpr std::size_t kShift = 3, kResidual = 6, kOwn = 7;  // rows; turns are the first

// What is known of digits: sums over the pairs beyond some joint, about its centre.
template <typename Number>
struct Gathered {
  std::array<Number, kPairProducts<0>> carried;  // of all that the next joint carries
  struct Angle {
    Vec<Number> turn, shift;  // sums of the angle's own column times these
    Number gradient;
    std::array<Number, kAnglesPerDigit> hessian;  // up to the angle itself
  };
  std::array<Angle, kAnglesPerDigit> angles;

  TEGATA_KERNEL Number& sum(std::size_t row, std::size_t column) {
    return carried[place(row, column)];
  }
  // Turns by a shift, shifts by a shift, what a turn has of all shifts.
  TEGATA_KERNEL Vec<Number> row(std::size_t row, std::size_t first) const {
    return {carried[place(row, first)], carried[place(row, first + 1)],
            carried[place(row, first + 2)]};
  }

  // To a centre from which the old one is at c: with t the moments and n the normals, t becomes
  // t + c x n. First (c x n) t^T is added, then t (c x n)^T with the new t.
  TEGATA_KERNEL void move_by(const Vec<Number>& c, std::size_t first_angle) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
#pragma GCC unroll 3
      for (std::size_t k = i; k < 3; ++k) add_cross(c, row(i, kShift), k, sum(k, i));
    }
#pragma GCC unroll 4
    for (std::size_t from = kShift; from <= kResidual; ++from) {
#pragma GCC unroll 3
      for (std::size_t k = 0; k < 3; ++k) add_cross(c, row(from, kShift), k, sum(from, k));
    }
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
#pragma GCC unroll 3
      for (std::size_t k = 0; k <= i; ++k) add_cross(c, row(i, kShift), k, sum(i, k));
    }
#pragma GCC unroll 4
    for (std::size_t angle = first_angle; angle < kAnglesPerDigit; ++angle) {
#pragma GCC unroll 3
      for (std::size_t k = 0; k < 3; ++k) {
        add_cross(c, angles[angle].shift, k, angles[angle].turn[k]);
      }
    }
  }
};

// Digits from `first` on; where there are no more, the last one again.
template <typename Set, typename Of>
TEGATA_KERNEL void get(std::size_t first, const Of& of_digit, typename Set::Number& number) {
#pragma GCC unroll 8
  for (std::size_t i = 0; i < Set::kCount; ++i) {
    number[i] = of_digit(std::min<std::size_t>(first + i, kDigitCount - 1));
  }
}

template <typename Set>
class Gathering {
 public:
  using Number = typename Set::Number;

  TEGATA_KERNEL Gathering(const std::array<DigitSums, kDigitCount>& sums, const SkinMotion& motion,
                          std::size_t first)
      : sums_(sums), motion_(motion), first_(first) {}

  TEGATA_KERNEL void run(Gathered<Number>& to) const {
    const Vec<Number> tip = centers(3), middle = centers(2), root = centers(1);
    const auto third = [&](std::size_t digit) { return sums_[digit].others[1].data(); };
    const auto second = [&](std::size_t digit) { return sums_[digit].others[0].data(); };
    const auto first = [&](std::size_t digit) { return sums_[digit].first.data(); };
    to.carried = {};
    add_joint<3, 3>(third, to);
    to.move_by({tip[0] - middle[0], tip[1] - middle[1], tip[2] - middle[2]}, 3);
    add_joint<2, 2>(second, to);
    to.move_by({middle[0] - root[0], middle[1] - root[1], middle[2] - root[2]}, 2);
    add_joint<0, 1>(first, to);
    to.move_by(root, 0);
  }

 private:
  TEGATA_KERNEL Vec<Number> centers(std::size_t angle) const {
    Vec<Number> vec;
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
      get<Set>(
          first_, [&](std::size_t d) { return motion_.digit(d).axes[angle].center[k]; }, vec[k]);
    }
    return vec;
  }
  TEGATA_KERNEL Vec<Number> directions(std::size_t angle) const {
    Vec<Number> vec;
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
      get<Set>(
          first_, [&](std::size_t d) { return motion_.digit(d).axes[angle].direction[k]; }, vec[k]);
    }
    return vec;
  }

  // The angles of a joint turn what is carried so far as a whole, and the pairs next to it as their
  // own columns say.
  template <std::size_t kFirst, std::size_t kLast, typename Of>
  TEGATA_KERNEL void add_joint(const Of& sums, Gathered<Number>& to) const {
    const auto product = [&](std::size_t row, std::size_t column, Number& number) {
      get<Set>(
          first_, [&](std::size_t d) { return sums(d)[place(row, column)]; }, number);
    };
    const std::array<Vec<Number>, 2> ways = {directions(kFirst), directions(kLast)};
#pragma GCC unroll 2
    for (std::size_t i = kFirst; i <= kLast; ++i) {
      const Vec<Number>& way = ways[i - kFirst];
      typename Gathered<Number>::Angle& angle = to.angles[i];
      Vec<Number> turn = {};
#pragma GCC unroll 3
      for (std::size_t k = 0; k < 3; ++k) {
        add_dot(way, to.row(k, 0), turn[k]);
        product(kOwn + i - kFirst, k, angle.turn[k]);
        angle.turn[k] += turn[k];
        product(kOwn + i - kFirst, kShift + k, angle.shift[k]);
        add_dot(way, to.row(kShift + k, 0), angle.shift[k]);
      }
      product(kOwn + i - kFirst, kResidual, angle.gradient);
      add_dot(way, to.row(kResidual, 0), angle.gradient);
#pragma GCC unroll 2
      for (std::size_t k = kFirst; k <= i; ++k) {
        product(kOwn + i - kFirst, kOwn + k - kFirst, angle.hessian[k]);
        add_dot(ways[k - kFirst], turn, angle.hessian[k]);
      }
#pragma GCC unroll 4
      for (std::size_t beyond = kLast + 1; beyond < kAnglesPerDigit; ++beyond) {
        to.angles[beyond].hessian[i] = Number{};
        add_dot(way, to.angles[beyond].turn, to.angles[beyond].hessian[i]);
      }
    }
#pragma GCC unroll 28
    for (std::size_t i = 0; i < to.carried.size(); ++i) {
      Number more;
      get<Set>(
          first_, [&](std::size_t d) { return sums(d)[i]; }, more);
      to.carried[i] += more;
    }
  }

  const std::array<DigitSums, kDigitCount>& sums_;
  const SkinMotion& motion_;
  std::size_t first_;
};

// What the pose has of sums. Returns half the sum of the squared residuals.
template <std::size_t kSums>
double add_to_pose(const std::array<double, kSums>& sums, FrameEquations& equations) {
  for (std::size_t column = 0; column < kPoseParameterCount; ++column) {
    for (std::size_t row = column; row < kPoseParameterCount; ++row) {
      equations.hessian(static_cast<int>(row), static_cast<int>(column)) +=
          sums[place(row, column)];
    }
    equations.gradient[static_cast<int>(column)] += sums[place(kResidual, column)];
  }
  return 0.5 * sums[place(kResidual, kResidual)];
}

template <typename Number>
void add_angles(const Gathered<Number>& gathered, std::size_t of, std::size_t digit,
                FrameEquations& equations) {
  const auto first = static_cast<int>(kPoseParameterCount + kAnglesPerDigit * digit);
  for (int i = 0; i < kAnglesPerDigit; ++i) {
    const auto& angle = gathered.angles[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) {
      equations.hessian(first + i, k) += angle.turn[static_cast<std::size_t>(k)][of];
      equations.hessian(first + i, 3 + k) += angle.shift[static_cast<std::size_t>(k)][of];
    }
    equations.gradient[first + i] += angle.gradient[of];
    for (int k = 0; k <= i; ++k) {
      equations.hessian(first + i, first + k) += angle.hessian[static_cast<std::size_t>(k)][of];
    }
  }
}

using PoseSums = std::array<double, kPairProducts<0>>;
using Run = void(const std::array<DigitSums, kDigitCount>&, const SkinMotion&, FrameEquations&,
                 PoseSums&);

template <typename Set>
TEGATA_KERNEL void run(const std::array<DigitSums, kDigitCount>& sums, const SkinMotion& motion,
                       FrameEquations& equations, PoseSums& pose) {
  for (std::size_t first = 0; first < kDigitCount; first += Set::kCount) {
    Gathered<typename Set::Number> gathered;
    Gathering<Set>(sums, motion, first).run(gathered);
    const std::size_t count = std::min<std::size_t>(Set::kCount, kDigitCount - first);
    for (std::size_t i = 0; i < count; ++i) add_angles(gathered, i, first + i, equations);
    for (std::size_t p = 0; p < pose.size(); ++p) {
      double sum = first == 0 ? 0.0 : pose[p];
      for (std::size_t i = 0; i < count; ++i) sum += gathered.carried[p][i];
      pose[p] = sum;
    }
  }
}
void run_baseline(const std::array<DigitSums, kDigitCount>& sums, const SkinMotion& motion,
                  FrameEquations& equations, PoseSums& pose) {
  run<Digits<2>>(sums, motion, equations, pose);
}
TEGATA_AVX2 void run_avx2(const std::array<DigitSums, kDigitCount>& sums, const SkinMotion& motion,
                          FrameEquations& equations, PoseSums& pose) {
  run<Digits<4>>(sums, motion, equations, pose);
}
TEGATA_AVX512 void run_avx512(const std::array<DigitSums, kDigitCount>& sums,
                              const SkinMotion& motion, FrameEquations& equations, PoseSums& pose) {
  run<Digits<8>>(sums, motion, equations, pose);
}

}  // namespace

double add_digit_sums(const std::array<DigitSums, kDigitCount>& sums, const SkinMotion& motion,
                      InstructionSet set, FrameEquations& equations) {
  constexpr std::array<Run*, 3> kRuns = {run_baseline, run_avx2, run_avx512};
  PoseSums pose;
  kRuns[static_cast<std::size_t>(set)](sums, motion, equations, pose);
  return add_to_pose(pose, equations);
}

double add_palm_sums(const PairSums<0>& sums, FrameEquations& equations) {
  return add_to_pose(sums, equations);
}

}  // namespace tegata
