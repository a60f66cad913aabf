// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// With weights w and the points p = (bone's matrix) rest, a row is at w0 p0 + w1 p1 + w2 p2 + w3 p3
// (0 is the palm, 1 to 3 the digit's bones outwards). An angle about an axis d through c moves the
// bones from its own outwards, so its column is the sum of w d x (p - c) over those, which is
// d x (sum of w p - (sum of w) c): one product for each angle, whatever the number of bones. The
// first two axes of a digit share their centre.
#include "tegata/hand/posed_rows.h"

#include <cmath>
#include <utility>

namespace tegata {
namespace {

using Bone = SkinMotion::Bone;
using Axis = SkinMotion::Axis;
using Motion = SkinMotion::Digit;

struct Vec {
  double x, y, z;
};

TEGATA_KERNEL Vec load(const RowPoints& points, std::size_t i) {
  return {points[0][i], points[1][i], points[2][i]};
}
TEGATA_KERNEL void store(const Vec& v, RowPoints& points, std::size_t i) {
  points[0][i] = v.x;
  points[1][i] = v.y;
  points[2][i] = v.z;
}
TEGATA_KERNEL Vec scaled(double factor, const Vec& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
TEGATA_KERNEL Vec sum(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
TEGATA_KERNEL double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
TEGATA_KERNEL Vec turned(const Bone& bone, const Vec& v) {
  return {bone.turn[0][0] * v.x + bone.turn[0][1] * v.y + bone.turn[0][2] * v.z,
          bone.turn[1][0] * v.x + bone.turn[1][1] * v.y + bone.turn[1][2] * v.z,
          bone.turn[2][0] * v.x + bone.turn[2][1] * v.y + bone.turn[2][2] * v.z};
}
TEGATA_KERNEL Vec moved(const Bone& bone, const Vec& v) {
  const Vec t = turned(bone, v);
  return {t.x + bone.shift[0], t.y + bone.shift[1], t.z + bone.shift[2]};
}
// direction x v
TEGATA_KERNEL Vec crossed(const Axis& axis, const Vec& v) {
  const double dx = axis.direction[0], dy = axis.direction[1], dz = axis.direction[2];
  return {dy * v.z - dz * v.y, dz * v.x - dx * v.z, dx * v.y - dy * v.x};
}
// From an axis' centre to each of some points with a weight, weighted.
TEGATA_KERNEL Vec arm(const Axis& axis, const Vec& weighted, double weight) {
  return {weighted.x - weight * axis.center[0], weighted.y - weight * axis.center[1],
          weighted.z - weight * axis.center[2]};
}

// What the axes turn: by the first two all of the digit, by the others less of it each. Loops write
// to one thing here and below, as the compiler would have to ask what overlaps.
struct Turned {
  alignas(64) RowPoints digit, middle, outer;
  alignas(64) RowPoints all;  // with the palm's part
};

TEGATA_KERNEL void add_up_positions(const Motion& motion, const SkinRows::Block& rest,
                                    Turned& turned) {
  const std::array<Bone, 4>& bones = motion.bones;
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const double w0 = rest.weights[0][i], w1 = rest.weights[1][i];
    const double w2 = rest.weights[2][i], w3 = rest.weights[3][i];
    const Vec p = load(rest.position, i);
    const Vec outer = scaled(w3, moved(bones[3], p));
    const Vec middle = sum(scaled(w2, moved(bones[2], p)), outer);
    const Vec digit = sum(scaled(w1, moved(bones[1], p)), middle);
    store(sum(scaled(w0, moved(bones[0], p)), digit), turned.all, i);
    store(arm(motion.axes[3], outer, w3), turned.outer, i);
    store(arm(motion.axes[2], middle, w2 + w3), turned.middle, i);
    store(arm(motion.axes[1], digit, w1 + (w2 + w3)), turned.digit, i);
  }
}

struct TurnedNormal {
  Vec digit, middle, outer;
};
TEGATA_KERNEL TurnedNormal turned_normal(const Motion& motion, const SkinRows::Block& rest,
                                         std::size_t i) {
  const Vec n = load(rest.normal, i);
  const Vec outer = scaled(rest.weights[3][i], turned(motion.bones[3], n));
  const Vec middle = sum(scaled(rest.weights[2][i], turned(motion.bones[2], n)), outer);
  return {sum(scaled(rest.weights[1][i], turned(motion.bones[1], n)), middle), middle, outer};
}

// Left as they come, not of unit length.
TEGATA_KERNEL void add_up_normals(const Motion& motion, const SkinRows::Block& rest,
                                  RowPoints& normals) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const Vec palm = turned(motion.bones[0], load(rest.normal, i));
    store(sum(scaled(rest.weights[0][i], palm), turned_normal(motion, rest, i).digit), normals, i);
  }
}

TEGATA_KERNEL void turn_columns(const std::array<Axis, 4>& axes, const Turned& turned,
                                AngleColumns& columns) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const Vec digit = load(turned.digit, i);
    store(crossed(axes[0], digit), columns[0], i);
    store(crossed(axes[1], digit), columns[1], i);
    store(crossed(axes[2], load(turned.middle, i)), columns[2], i);
    store(crossed(axes[3], load(turned.outer, i)), columns[3], i);
  }
}

// Normals to unit length: n = m / |m|.
TEGATA_KERNEL void normalise(PosedPoints& points) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const Vec m = load(points.normal, i);
    const double squared = dot(m, m);
    const double inverse = 1.0 / std::sqrt(squared);
    const double factor = squared > 0.0 ? inverse : 0.0;
    store(scaled(factor, m), points.normal, i);
    points.inverse_length[i] = factor;
  }
}

TEGATA_KERNEL void pose_digit(const Motion& motion, const SkinRows::Block& rest,
                              PosedPoints& points, AngleColumns& columns) {
  Turned turned;
  add_up_positions(motion, rest, turned);
  points.position = turned.all;
  turn_columns(motion.axes, turned, columns);
  add_up_normals(motion, rest, points.normal);
}

TEGATA_KERNEL void pose_palm(const Bone& palm, const SkinRows::Block& rest, PosedPoints& points) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    store(moved(palm, load(rest.position, i)), points.position, i);
    store(turned(palm, load(rest.normal, i)), points.normal, i);
  }
}

// What a turn does to a normal n = m / |m|: (dm - n (n . dm)) / |m|, with dm that of m.
TEGATA_KERNEL Vec normal_column(const Axis& axis, const Vec& turned, const Vec& n, double factor) {
  const Vec dm = crossed(axis, turned);
  return scaled(factor, sum(dm, scaled(-dot(n, dm), n)));
}
TEGATA_KERNEL void turn_normals(const Motion& motion, const SkinRows::Block& rest,
                                const PosedPoints& points, AngleColumns& found) {
  const std::array<Axis, 4>& axes = motion.axes;
  alignas(64) AngleColumns columns;
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    const TurnedNormal turned = turned_normal(motion, rest, i);
    const Vec n = load(points.normal, i);
    const double factor = points.inverse_length[i];
    store(normal_column(axes[0], turned.digit, n, factor), columns[0], i);
    store(normal_column(axes[1], turned.digit, n, factor), columns[1], i);
    store(normal_column(axes[2], turned.middle, n, factor), columns[2], i);
    store(normal_column(axes[3], turned.outer, n, factor), columns[3], i);
  }
  found = columns;
}

enum class Pass { pose, normalise, both };

struct Task {
  const SkinRows* rows;
  const SkinMotion* motion;
  PosedPoints* points;
  AngleColumns* columns;
};

TEGATA_KERNEL void run(const Task& task, Pass pass) {
  const SkinRows::Block* rest = task.rows->blocks().data();
  for (std::size_t part = 0; part < task.rows->parts().size(); ++part) {
    const bool is_palm = part == SkinRows::kPalmPart;
    const Motion motion = task.motion->digit(is_palm ? 0 : part);
    for (std::size_t b = task.rows->parts()[part].first; b < task.rows->parts()[part].last; ++b) {
      if (pass != Pass::normalise) {
        if (is_palm) {
          pose_palm(motion.bones[0], rest[b], task.points[b]);
        } else {
          pose_digit(motion, rest[b], task.points[b], task.columns[b]);
        }
      }
      if (pass != Pass::pose) normalise(task.points[b]);
    }
  }
}

using Run = void(const Task&, Pass);

void run_baseline(const Task& task, Pass pass) { run(task, pass); }
TEGATA_AVX2 void run_avx2(const Task& task, Pass pass) { run(task, pass); }
TEGATA_AVX512 void run_avx512(const Task& task, Pass pass) { run(task, pass); }

using TurnNormals = void(const Motion&, const SkinRows::Block&, const PosedPoints&, AngleColumns&);

void turn_normals_baseline(const Motion& motion, const SkinRows::Block& rest,
                           const PosedPoints& points, AngleColumns& columns) {
  turn_normals(motion, rest, points, columns);
}
TEGATA_AVX2 void turn_normals_avx2(const Motion& motion, const SkinRows::Block& rest,
                                   const PosedPoints& points, AngleColumns& columns) {
  turn_normals(motion, rest, points, columns);
}
TEGATA_AVX512 void turn_normals_avx512(const Motion& motion, const SkinRows::Block& rest,
                                       const PosedPoints& points, AngleColumns& columns) {
  turn_normals(motion, rest, points, columns);
}

}  // namespace

PosedRows::PosedRows(std::shared_ptr<const SkinRows> rows, const HandModel& model)
    : rows_(std::move(rows)),
      motion_(model),
      points_(std::make_unique_for_overwrite<PosedPoints[]>(rows_->blocks().size())),
      columns_(
          std::make_unique_for_overwrite<AngleColumns[]>(rows_->parts()[kDigitCount - 1].last)) {}

void PosedRows::move_to(const HandPose& pose, InstructionSet set) {
  motion_.move_to(pose, set);
  constexpr std::array<Run*, 3> kRuns = {run_baseline, run_avx2, run_avx512};
  Run* const run_best = kRuns[static_cast<std::size_t>(set)];
  const Task task{rows_.get(), &motion_, points_.get(), columns_.get()};
  if (rows_->shared().empty()) {
    run_best(task, Pass::both);
  } else {
    run_best(task, Pass::pose);
    sum_shared();
    run_best(task, Pass::normalise);
  }
}

AngleColumns PosedRows::normal_columns(std::size_t block, InstructionSet set) const {
  constexpr std::array<TurnNormals*, 3> kTurns = {turn_normals_baseline, turn_normals_avx2,
                                                  turn_normals_avx512};
  AngleColumns columns;
  kTurns[static_cast<std::size_t>(set)](motion_.digit(rows_->part_of_row(block * kRowLanes)),
                                        rows_->blocks()[block], points_[block], columns);
  return columns;
}

// Each row of a shared vertex has its own digit's part only: all get the sum.
void PosedRows::sum_shared() {
  const auto sum_up = [&](const std::vector<std::uint32_t>& shared,
                          RowPoints PosedPoints::*points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double sum = 0.0;
      for (const std::uint32_t row : shared) {
        sum += (points_[row / kRowLanes].*points)[axis][row % kRowLanes];
      }
      for (const std::uint32_t row : shared) {
        (points_[row / kRowLanes].*points)[axis][row % kRowLanes] = sum;
      }
    }
  };
  for (const SkinRows::SharedVertex& shared : rows_->shared()) {
    sum_up(shared.rows, &PosedPoints::position);
    sum_up(shared.rows, &PosedPoints::normal);
  }
}

}  // namespace tegata
