// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/warm_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tegata/base/angle.h"
#include "tegata/base/random.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr double kSkinRadiance = 0.70;

// Slow waves through space; fixed to the skin by evaluating them in the rest pose.
class SkinTexture {
 public:
  explicit SkinTexture(Random& random) {
    for (Wave& wave : waves_) {
      const Eigen::Vector3d direction =
          Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      const double length = random.uniform(0.018, 0.07);  // [m]
      wave.vector = 2.0 * std::numbers::pi / length * direction;
      wave.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    }
  }
  // Mostly within 0.04.
  double at(const Eigen::Vector3d& point) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::sin(wave.vector.dot(point) + wave.phase);
    return 0.012 * sum;
  }

 private:
  struct Wave {
    Eigen::Vector3d vector;
    double phase = 0.0;
  };
  std::array<Wave, 7> waves_;
};

// How far out a digit a vertex is that moves with a bone: 0 at the digit's root, 1 at its tip.
double way_to_tip(const Skeleton& skeleton, int bone, const Eigen::Vector3d& rest_vertex) {
  if (bone == 0) return 0.0;
  const Eigen::Vector3d near =
      skeleton.keypoints[static_cast<std::size_t>(proximal_keypoint(bone))];
  const Eigen::Vector3d far = skeleton.keypoints[static_cast<std::size_t>(distal_keypoint(bone))];
  const Eigen::Vector3d along = far - near;
  const double share = (rest_vertex - near).dot(along) / along.squaredNorm();
  return ((bone - 1) % 3 + std::clamp(share, 0.0, 1.0)) / 3.0;
}

// The cross-section where the rest surface ends behind the wrist.
struct Stump {
  Eigen::Vector3d center;  // a little inside the end
  double half_breadth, half_thickness;
};

Stump find_stump(const TriangleMesh& surface) {
  constexpr double kEndCap = 0.008, kBand = 0.02;  // [m]
  double end = surface.vertices[0].y();
  for (const Eigen::Vector3d& vertex : surface.vertices) end = std::min(end, vertex.y());
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : surface.vertices) {
    if (vertex.y() < end + kBand) box.extend(vertex);
  }
  Eigen::Vector3d center = box.center();
  center.y() = end + kEndCap;
  return {center, 0.5 * box.sizes().x(), 0.5 * box.sizes().z()};
}

}  // namespace

std::vector<float> skin_radiance(const HandModel& hand, std::uint64_t seed) {
  Random random(seed);
  const SkinTexture texture(random);
  std::array<double, kDigitCount> cooling;
  for (double& share : cooling) share = random.uniform(0.04, 0.10);
  // Texture and digits are fixed to the bones of the zero pose, in which keypoints are known; a
  // rest surface given at other angles only shifts the texture.
  const auto zero_from_rest = bone_transforms(hand.skeleton, hand.rest_angles);
  std::vector<float> radiance;
  for (std::size_t i = 0; i < hand.links.size(); ++i) {
    double value = kSkinRadiance + texture.at(hand.rest_surface.vertices[i]);
    for (std::size_t k = 0; k < hand.links[i].bones.size(); ++k) {
      const int bone = hand.links[i].bones[k];
      const double weight = hand.links[i].weights[k];
      if (bone == 0 || weight == 0.0) continue;
      const Eigen::Vector3d at_zero =
          zero_from_rest[static_cast<std::size_t>(bone)].inverse() * hand.rest_surface.vertices[i];
      const double way = way_to_tip(hand.skeleton, bone, at_zero);
      value *= 1.0 - weight * cooling[static_cast<std::size_t>((bone - 1) / 3)] * way * way;
    }
    radiance.push_back(static_cast<float>(value));
  }
  return radiance;
}

WarmSurface forearm_surface(const HandModel& hand, std::uint64_t seed) {
  constexpr int kRings = 60, kSides = 48;
  constexpr double kEnd = 0.25;                                   // beyond the wrist [m]
  constexpr double kHalfBreadth = 0.040, kHalfThickness = 0.035;  // where it ends [m]
  Random random(seed);
  const SkinTexture texture(random);
  const Stump stump = find_stump(hand.rest_surface);
  const double length = kEnd + stump.center.y();
  const double bend = random.uniform(0.0, 15.0) * kDegree;
  const double bend_way = random.uniform(0.0, 2.0 * std::numbers::pi);
  const Eigen::Quaterniond bent =
      so3_exp(bend * Eigen::Vector3d(std::cos(bend_way), 0.0, std::sin(bend_way)));

  WarmSurface forearm;
  const auto add = [&](const Eigen::Vector3d& offset) {
    const Eigen::Vector3d point = stump.center + bent * offset;
    forearm.mesh.vertices.push_back(point);
    forearm.radiance.push_back(static_cast<float>(kSkinRadiance + texture.at(point)));
  };
  for (int ring = 0; ring <= kRings; ++ring) {
    const double share = static_cast<double>(ring) / kRings;
    const double swell = 0.5 - 0.5 * std::cos(std::numbers::pi * share);
    const double breadth = std::lerp(stump.half_breadth, kHalfBreadth, swell);
    const double thickness = std::lerp(stump.half_thickness, kHalfThickness, swell);
    for (int side = 0; side < kSides; ++side) {
      const double around = 2.0 * std::numbers::pi * side / kSides;
      add({breadth * std::cos(around), -share * length, thickness * std::sin(around)});
    }
  }
  add(Eigen::Vector3d::Zero());
  add({0.0, -length, 0.0});
  const auto index = [](int ring, int side) {
    return static_cast<std::uint32_t>(ring * kSides + side % kSides);
  };
  const auto near_cap = static_cast<std::uint32_t>((kRings + 1) * kSides), far_cap = near_cap + 1;
  for (int side = 0; side < kSides; ++side) {
    forearm.mesh.triangles.push_back({near_cap, index(0, side + 1), index(0, side)});
    forearm.mesh.triangles.push_back({far_cap, index(kRings, side), index(kRings, side + 1)});
    for (int ring = 0; ring < kRings; ++ring) {
      const std::uint32_t a = index(ring, side), b = index(ring, side + 1);
      const std::uint32_t c = index(ring + 1, side + 1), d = index(ring + 1, side);
      forearm.mesh.triangles.push_back({a, b, c});
      forearm.mesh.triangles.push_back({a, c, d});
    }
  }
  return forearm;
}

WarmSurface joined(const WarmSurface& a, const WarmSurface& b) {
  WarmSurface both;
  both.mesh.vertices = a.mesh.vertices;
  both.mesh.vertices.insert(both.mesh.vertices.end(), b.mesh.vertices.begin(),
                            b.mesh.vertices.end());
  both.mesh.triangles = a.mesh.triangles;
  const auto offset = static_cast<std::uint32_t>(a.mesh.vertices.size());
  for (const Triangle& t : b.mesh.triangles) {
    both.mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  both.radiance = a.radiance;
  both.radiance.insert(both.radiance.end(), b.radiance.begin(), b.radiance.end());
  return both;
}

WarmSurface moved(const Rigid3d& b_from_a, WarmSurface surface_in_a) {
  for (Eigen::Vector3d& vertex : surface_in_a.mesh.vertices) vertex = b_from_a * vertex;
  surface_in_a.mesh.normals.clear();
  return surface_in_a;
}

}  // namespace tegata
