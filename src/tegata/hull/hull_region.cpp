// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/hull_region.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <string>

#include "tegata/base/error.h"

namespace tegata {
namespace {

// Survivors are looked for in 2^6 cells a side, again and again in the box of the last ones, until
// it keeps nine tenths of each side.
constexpr int kDepth = 6;
constexpr double kSettled = 0.9;
constexpr int kMostRounds = 60;
// The first cube reaches twice as far as what the cameras look at. Where that leaves nothing or
// cuts something off, it is doubled so many times: the lines of sight may meet far behind.
constexpr int kMostDoublings = 4;

struct Ray {
  Eigen::Vector3d from, direction;
};

// How far from the cameras to look: twice the largest distance to the point that comes nearest to
// all middle rays, and no less than the distances between cameras.
double first_reach(const SilhouetteField& field) {
  constexpr double kParallel = 1e-3;
  // Where rays are parallel the target is anywhere along them.
  constexpr double kBaselinesForParallelRays = 10.0;
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < field.view_count(); ++i) {
    rays.push_back({field.camera(i).center_in_world(), field.middle_direction(i)});
  }
  const Eigen::Vector3d origin = rays.front().from;
  double baseline = 0.0;
  for (const Ray& ray : rays) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    normal_matrix += across;
    right_side += across * (ray.from - origin);
    for (const Ray& other : rays) baseline = std::max(baseline, (ray.from - other.from).norm());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal_matrix);
  if (solver.eigenvalues()[0] < kParallel * static_cast<double>(rays.size())) {
    return kBaselinesForParallelRays * baseline;
  }
  const Eigen::Vector3d target = origin + normal_matrix.ldlt().solve(right_side);
  double farthest = baseline;
  for (const Ray& ray : rays) farthest = std::max(farthest, (ray.from - target).norm());
  return 2.0 * farthest;
}

// The box around the cameras and around what their foregrounds cover up to a depth of `reach`.
Eigen::AlignedBox3d viewing_volume(const SilhouetteField& field, double reach) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < field.view_count(); ++i) {
    const Camera& camera = field.camera(i);
    const Eigen::AlignedBox2i pixels = field.foreground(i);
    const Eigen::Vector3d center = camera.center_in_world();
    box.extend(center);
    if (pixels.isEmpty()) continue;
    for (const int x : {pixels.min().x() - 1, pixels.max().x() + 1}) {
      for (const int y : {pixels.min().y() - 1, pixels.max().y() + 1}) {
        const Eigen::Vector3d direction = pixel_direction(camera, Eigen::Vector2d(x, y));
        const double cosine = (camera.camera_from_world.rotation * direction).z();
        box.extend(center + reach / cosine * direction);
      }
    }
  }
  return box;
}

// Finds the box of all cells of a cube that cannot be called outside. Cubes that lie in the box
// found so far cannot widen it and are not divided.
class SurvivorSearch {
 public:
  explicit SurvivorSearch(const SilhouetteField& field) : field_(field) {}

  Eigen::AlignedBox3d run(const Eigen::AlignedBox3d& around) {
    found_.setEmpty();
    visit(around.center(), 0.5 * around.sizes().maxCoeff(), 0, {});
    return found_;
  }

 private:
  void visit(const Eigen::Vector3d& center, double half_side, int level,
             SilhouetteField::State state) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(half_side);
    const Eigen::AlignedBox3d cube(center - reach, center + reach);
    if (found_.contains(cube)) return;
    const Occupancy occupancy = field_.classify(center, half_side, state);
    if (occupancy == Occupancy::outside) return;
    if (occupancy == Occupancy::inside || level == kDepth) {
      found_.extend(cube);
      return;
    }
    const double quarter = 0.5 * half_side;
    for (int i = 0; i < 8; ++i) {
      visit(center +
                quarter * Eigen::Vector3d((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1),
            quarter, level + 1, state);
    }
  }

  const SilhouetteField& field_;
  Eigen::AlignedBox3d found_;
};

// The box of survivors within `start`, refined until it settles; empty where there are none.
Eigen::AlignedBox3d refined(const SilhouetteField& field, const Eigen::AlignedBox3d& start) {
  SurvivorSearch search(field);
  Eigen::AlignedBox3d box = start;
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::AlignedBox3d smaller = search.run(box).intersection(box);
    if (smaller.isEmpty()) return smaller;
    const bool settled = (smaller.sizes().array() >= kSettled * box.sizes().array()).all();
    box = smaller;
    if (settled) break;
  }
  return box;
}

// Whether a box comes to the limits of the volume in which it was looked for.
bool is_cut_off(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& volume) {
  constexpr double kNear = 1e-6;
  const double slack = kNear * volume.sizes().maxCoeff();
  return ((box.min() - volume.min()).array() <= slack).any() ||
         ((volume.max() - box.max()).array() <= slack).any();
}

// The region, or an empty box where no point survives.
Eigen::AlignedBox3d search_region(const SilhouetteField& field) {
  double reach = first_reach(field);
  Eigen::AlignedBox3d first;
  for (int doubling = 0; doubling <= kMostDoublings; ++doubling, reach *= 2.0) {
    const Eigen::AlignedBox3d volume = viewing_volume(field, reach);
    const Eigen::AlignedBox3d box = refined(field, volume);
    if (box.isEmpty()) continue;
    if (!is_cut_off(box, volume)) return box;
    if (first.isEmpty()) first = box;
  }
  return first;  // that of silhouettes whose common volume has no end, cut off where it first was
}

}  // namespace

Eigen::AlignedBox3d locate_region(const SilhouetteField& field) {
  // What only two views see may be there by chance, if nothing is that many see.
  if (!field.asks_pairs() || !search_region(field.by_number()).isEmpty()) {
    const Eigen::AlignedBox3d region = search_region(field);
    if (!region.isEmpty()) return region;
  }
  constexpr const char* kCauses =
      ": are cameras swapped, frames of different times, the calibration or its scale wrong, or a "
      "mask on something else than the hand?";
  if (field.view_count() == 2) {
    throw Error("hull: the silhouettes of '", field.name(0), "' and '", field.name(1),
                "' have no point in common", kCauses);
  }
  std::string suspects;
  for (std::size_t i = 0; i < field.view_count(); ++i) {
    if (search_region(field.without(i)).isEmpty()) continue;
    suspects += text(suspects.empty() ? "without '" : " or without '", field.name(i), "'");
  }
  if (suspects.empty()) {
    throw Error("hull: the silhouettes of the ", field.view_count(),
                " views have no point in common, and leaving out any one of them does not help",
                kCauses);
  }
  throw Error("hull: the silhouettes of the ", field.view_count(),
              " views have no point in common; ", suspects, " something would remain", kCauses);
}

}  // namespace tegata
