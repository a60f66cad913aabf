// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "chain_tracker.h"

#include <algorithm>
#include <cmath>

#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/known_grasp.h"
#include "tegata/math/so3.h"

namespace tegata::bench {
namespace {

constexpr int kVoxels = 128;
constexpr double kVoxelSize = 0.002;  // [m]
constexpr std::size_t kTriangles = 4000;

// Vertices with the normals of the triangles about them, weighted by area.
FlatHull points_of(const FlatMesh& mesh, const std::vector<std::uint32_t>& triangles,
                   std::size_t most, const FlatCube& cube) {
  std::vector<float> normals(mesh.vertices.size(), 0.0F);
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const float* corners[3];
    for (std::size_t c = 0; c < 3; ++c) corners[c] = &mesh.vertices[3 * triangles[t + c]];
    float u[3], v[3];
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = corners[1][k] - corners[0][k];
      v[k] = corners[2][k] - corners[0][k];
    }
    const float normal[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) normals[3 * triangles[t + c] + k] += normal[k];
    }
  }
  const std::size_t step = std::max<std::size_t>(1, normals.size() / 3 / most);
  FlatHull hull;
  for (std::size_t i = 0; i < normals.size(); i += 3 * step) {
    const double normal[3] = {normals[i], normals[i + 1], normals[i + 2]};
    const double length = std::sqrt(flat_dot(normal, normal));
    if (!(length > 0.0)) continue;  // of no triangle any more
    for (std::size_t k = 0; k < 3; ++k) {
      hull.points.push_back(cube.origin[k] + cube.voxel_size * (mesh.vertices[i + k] + 0.5));
      hull.normals.push_back(normal[k] / length);
    }
  }
  return hull;
}

}  // namespace

ChainTracker::ChainTracker(const HandStream& stream, bool simplifies)
    : stream_(stream), simplifies_(simplifies) {
  for (const auto& views : stream.frames) frames_.push_back(flat(views));
  pair_fit_.model = stream.model;
  pair_fit_.rows = stream.hand.rows;
  pair_fit_.start = {stream.angles, {stream.poses.front()}};
  // A pair a vertex, with the normal at rest.
  std::vector<SurfacePair>& pairs = pair_fit_.frames.emplace_back();
  const TriangleMesh& rest = stream.model.rest_surface;
  for (std::uint32_t v = 0; v < rest.vertices.size(); ++v) {
    pairs.push_back({v, rest.vertices[v], rest.normals[v], 1.0});
  }
  const FlatFrame frame = flat_fit(pair_fit_).frames.front();
  hand_.vertices = frame.pairs;
  std::copy(std::begin(frame.part_end), std::end(frame.part_end), std::begin(hand_.part_end));
  pairs.clear();
}

FlatHull ChainTracker::hull(std::size_t frame, const Eigen::Vector3d& center, int threads) {
  const double reach = 0.5 * kVoxels * kVoxelSize;
  const FlatCube cube{
      {center.x() - reach, center.y() - reach, center.z() - reach}, kVoxelSize, kVoxels};
  constexpr int kLayers = 8;
  inside_.resize(static_cast<std::size_t>(kVoxels) * kVoxels * kVoxels);
  parallel_for(kVoxels / kLayers, threads, [&](std::size_t slab) {
    const int first = kLayers * static_cast<int>(slab);
    carve_slab_naively(frames_[frame], cube, first, first + kLayers, inside_);
  });
  const FlatMesh mesh = vtk_surface_of_voxels(inside_, kVoxels);
  return points_of(mesh, simplifies_ ? meshoptimizer_triangles(mesh, kTriangles) : mesh.triangles,
                   simplifies_ ? mesh.vertices.size() : kTriangles / 2, cube);
}

Eigen::Vector3d ChainTracker::center_of(const HandPose& pose) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : posed_keypoints(stream_.model.skeleton, pose)) {
    box.extend(point);
  }
  return box.center();
}

HandPose ChainTracker::followed(const HandPose& expected, const JointAngles& before,
                                const FlatHull& hull, double& rounds) {
  pair_fit_.start = {expected.angles, {expected.world_from_hand}};
  const FlatMotionAt motion_at = flat_fit(pair_fit_).frames.front().motion_at;
  double pose[kFlatPose] = {};
  HandPose found = expected;
  rounds += fit_to_hull(hand_, motion_at, hull, icp, before.data(), pose, found.angles.data());
  Rigid3d& to = found.world_from_hand;
  to.rotation = (so3_exp({pose[0], pose[1], pose[2]}) * to.rotation).normalized();
  to.translation += Eigen::Vector3d(pose[3], pose[4], pose[5]);
  return found;
}

ChainTracker::Run ChainTracker::run(int threads) {
  give_vtk_threads(threads);
  Run sum;
  HandPose last{stream_.poses.front(), stream_.angles}, last_but_one = last;
  const std::size_t count = frames_.size();
  FlatHull current = hull(1, center_of(last), threads), next;
  for (std::size_t f = 1; f < count; ++f) {
    const Eigen::Vector3d center = center_of(last);
    HandPose found;
    parallel_for(2, threads, [&](std::size_t job) {
      const Stopwatch watch;
      if (job == 0) {
        const HandPose expected{
            f == 1 ? last.world_from_hand
                   : extrapolated(last_but_one.world_from_hand, last.world_from_hand),
            last.angles};
        found = followed(expected, last.angles, current, sum.rounds);
        sum.fit_seconds += watch.seconds();
      } else if (f + 1 < count) {
        next = hull(f + 1, center, threads);
        sum.hull_seconds += watch.seconds();
      }
    });
    std::swap(current, next);
    last_but_one = last;
    last = found;
    sum.keypoint_error += stream_.keypoint_error(f, found);
  }
  give_vtk_threads(1);
  const double frames = static_cast<double>(count - 1);
  return {sum.keypoint_error / frames, sum.rounds / frames, sum.hull_seconds / frames,
          sum.fit_seconds / frames};
}

}  // namespace tegata::bench
