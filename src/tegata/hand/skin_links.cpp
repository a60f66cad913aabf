// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_links.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tegata {
namespace {

double squared_distance(const std::array<Eigen::Vector3d, 2>& segment,
                        const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = segment[1] - segment[0];
  const double part = std::clamp((point - segment[0]).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (segment[0] + part * way - point).squaredNorm();
}

// How many times the distance to the first bone a step goes on mixing. Between palm and digits are
// webs, which must stretch over their whole width.
double blend_width(int a, int b) { return std::min(a, b) == 0 ? 1.5 : 1.0; }

// How far the palm reaches out between the fingers, as a part of their first bones.
constexpr double kWebPart = 0.12;

bool are_joined(int a, int b) { return parent_bone(a) == b || parent_bone(b) == a; }

}  // namespace

BoneSegments bone_segments(const Skeleton& skeleton, const JointAngles& angles,
                           double forearm_length, double wrist_half_breadth) {
  HandPose pose;
  pose.angles = angles;
  const auto keypoints = posed_keypoints(skeleton, pose);
  BoneSegments segments;
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    segments[0].push_back({keypoints[0], keypoints[1 + 4 * digit]});
    for (std::size_t i = 0; i < 3; ++i) {
      segments[1 + 3 * digit + i].push_back(
          {keypoints[1 + 4 * digit + i], keypoints[2 + 4 * digit + i]});
    }
  }
  // The webs between the fingers.
  for (std::size_t digit = 1; digit + 1 < kDigitCount; ++digit) {
    const std::size_t a = 1 + 4 * digit, b = a + 4;
    const Eigen::Vector3d root = 0.5 * (keypoints[a] + keypoints[b]);
    const Eigen::Vector3d outer = 0.5 * (keypoints[a + 1] + keypoints[b + 1]);
    segments[0].push_back({keypoints[0], root});
    segments[0].push_back({root, root + kWebPart * (outer - root)});
  }
  for (const double side : {-0.6, 0.6}) {
    const Eigen::Vector3d wrist(side * wrist_half_breadth, 0.0, 0.0);
    segments[0].push_back({wrist, wrist - Eigen::Vector3d(0.0, forearm_length, 0.0)});
  }
  return segments;
}

SkinLinks link_to_bones(const BoneSegments& segments, const Eigen::Vector3d& point) {
  std::array<double, kBoneCount> distances;  // squared
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    distances[bone] = std::numeric_limits<double>::infinity();
    for (const auto& segment : segments[bone]) {
      distances[bone] = std::min(distances[bone], squared_distance(segment, point));
    }
  }
  const auto nearest = std::min_element(distances.begin(), distances.end());
  const int first = static_cast<int>(nearest - distances.begin());
  int second = -1;
  for (int bone = 0; bone < kBoneCount; ++bone) {
    if (are_joined(first, bone) &&
        (second < 0 ||
         distances[static_cast<std::size_t>(bone)] < distances[static_cast<std::size_t>(second)])) {
      second = bone;
    }
  }
  // Beside a joint, at distance d from both bones' common end, a step s along the first bone leaves
  // the second at sqrt(d^2 + s^2): this is s / d.
  const double step =
      std::sqrt(std::max(
          distances[static_cast<std::size_t>(second)] / std::max(*nearest, 1e-12) - 1.0, 0.0)) /
      blend_width(first, second);
  const double weight = step < 1.0 ? 0.5 - step * (0.75 - 0.25 * step * step) : 0.0;
  SkinLinks links;
  links.bones = {first, second, 0, 0};
  links.weights = {1.0 - weight, weight, 0.0, 0.0};
  return links;
}

void smooth_palm_links(const TriangleMesh& surface, int rounds, std::vector<SkinLinks>& links) {
  const auto share = [](const SkinLinks& of, int bone) {
    double sum = 0.0;
    for (std::size_t i = 0; i < of.bones.size(); ++i) {
      if (of.bones[i] == bone) sum += of.weights[i];
    }
    return sum;
  };
  for (int round = 0; round < rounds; ++round) {
    // Every neighbour counts twice, once for each triangle that it shares; so does the vertex.
    std::vector<std::array<double, 2>> sums(links.size());
    for (std::size_t v = 0; v < links.size(); ++v) {
      sums[v] = {2.0 * links[v].weights[0], 2.0 * links[v].weights[1]};
    }
    for (const Triangle& triangle : surface.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = triangle[i];
        for (const std::uint32_t other : {triangle[(i + 1) % 3], triangle[(i + 2) % 3]}) {
          sums[v][0] += share(links[other], links[v].bones[0]);
          sums[v][1] += share(links[other], links[v].bones[1]);
        }
      }
    }
    for (std::size_t v = 0; v < links.size(); ++v) {
      if (links[v].bones[0] != 0 && links[v].bones[1] != 0) continue;
      const double first = sums[v][0] / (sums[v][0] + sums[v][1]);
      links[v].weights = {first, 1.0 - first, 0.0, 0.0};
    }
  }
  for (SkinLinks& of : links) {
    if (of.weights[0] >= of.weights[1]) continue;
    std::swap(of.weights[0], of.weights[1]);
    std::swap(of.bones[0], of.bones[1]);
  }
}

}  // namespace tegata
