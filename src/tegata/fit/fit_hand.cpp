// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/fit_hand.h"

#include <algorithm>
#include <utility>

namespace tegata {
namespace {

constexpr double kReferenceLength = 0.18;  // wrist to the middle fingertip of a mean adult [m]
constexpr std::size_t kMostSamples = 600;

std::vector<SurfaceEdge> unique_edges(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  pairs.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      pairs.push_back(std::minmax(triangle[i], triangle[(i + 1) % 3]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<SurfaceEdge> edges;
  edges.reserve(pairs.size());
  for (const auto& [a, b] : pairs) edges.push_back({a, b});
  return edges;
}

}  // namespace

FitHand::FitHand(const HandModel& hand)
    : model(&hand),
      rows(std::make_shared<const SkinRows>(hand)),
      edges(unique_edges(hand.rest_surface)),
      drawn(hand.rest_surface.triangles),
      drawn_beyond_wrist({}),
      capsules(hand) {
  const auto& keypoints = hand.skeleton.keypoints;
  scale = (keypoints[kMiddleTip] - keypoints[kWrist]).norm() / kReferenceLength;
  beyond_wrist.reserve(hand.rest_surface.vertices.size());
  for (const Eigen::Vector3d& vertex : hand.rest_surface.vertices) {
    beyond_wrist.push_back(vertex.y() > keypoints[kWrist].y() ? 1 : 0);
  }
  std::vector<Triangle> beyond = hand.rest_surface.triangles;
  std::erase_if(beyond, [&](const Triangle& triangle) {
    return beyond_wrist[triangle[0]] == 0 && beyond_wrist[triangle[1]] == 0 &&
           beyond_wrist[triangle[2]] == 0;
  });
  drawn_beyond_wrist = EdgedTriangles(beyond);
  const std::size_t step = 1 + beyond_wrist.size() / kMostSamples;
  for (std::size_t i = 0; i < beyond_wrist.size(); i += step) {
    if (beyond_wrist[i] != 0) samples.push_back(static_cast<std::uint32_t>(i));
  }
}

FitHand FitHand::with_model(const HandModel& hand) const {
  FitHand other = *this;
  other.model = &hand;
  other.rows = std::make_shared<const SkinRows>(hand);
  other.capsules = DigitCapsules(hand);
  return other;
}

}  // namespace tegata
