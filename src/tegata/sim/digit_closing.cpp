// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/digit_closing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tegata/base/angle.h"

namespace tegata {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kSoftPad = 0.8e-3;  // how deep skin gives way without a cost [m]

double square(double x) { return x * x; }

std::size_t near_keypoint(int digit, int bone_of_digit) {
  return static_cast<std::size_t>(1 + 4 * digit + bone_of_digit);
}

// The least distance between points of two bones' axes, to about a millimetre.
double axis_distance(const std::array<Eigen::Vector3d, 2>& a,
                     const std::array<Eigen::Vector3d, 2>& b) {
  constexpr int kSteps = 6;
  const Eigen::Vector3d along = b[1] - b[0];
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    const Eigen::Vector3d point = a[0] + (a[1] - a[0]) * i / kSteps;
    const double share = std::clamp((point - b[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (b[0] + share * along - point).norm());
  }
  return least;
}

// What closed_digit() minimises, in square millimetres.
class ClosingCost {
 public:
  ClosingCost(const HandModel& hand, const DigitSurface& digit,
              const std::vector<const DigitSurface*>& others, const DigitGoal& goal,
              const PlacedObject& object)
      : hand_(hand), digit_(digit), others_(others), goal_(goal), object_(object) {}

  double at(const JointAngles& angles) const {
    return contact_cost(angles) + posture_cost(angles) + place_cost(angles);
  }

 private:
  double contact_cost(const JointAngles& angles) const {
    constexpr double kPenetrationWeight = 40.0;
    const std::array<double, 3> clearances = digit_.clearances(angles, object_);
    double cost = 0.0;
    for (int bone = 0; bone < 3; ++bone) {
      const double clearance = clearances[static_cast<std::size_t>(bone)];
      cost += goal_.contact[bone] * square(std::max(0.0, clearance + 0.5 * kSoftPad) / kMillimetre);
      cost += kPenetrationWeight * square(std::min(0.0, clearance + kSoftPad) / kMillimetre);
    }
    return cost;
  }

  double posture_cost(const JointAngles& angles) const {
    const Eigen::Vector4d off = (angles.segment<4>(4 * digit_.digit()) - goal_.preferred) / kDegree;
    return goal_.stiffness.dot(off.cwiseAbs2());
  }

  double place_cost(const JointAngles& angles) const {
    constexpr double kOverlapWeight = 3.0, kTargetWeight = 0.3, kSqueeze = 1.5e-3;
    const auto keypoints = posed_keypoints(hand_.skeleton, HandPose{{}, angles});
    double cost = 0.0;
    if (goal_.tip_target) {
      const Eigen::Vector3d& tip = keypoints[near_keypoint(digit_.digit(), 3)];
      cost += kTargetWeight * (tip - *goal_.tip_target).squaredNorm() / square(kMillimetre);
    }
    for (const DigitSurface* other : others_) {
      for (int mine = 1; mine < 3; ++mine) {
        for (int its = 0; its < 3; ++its) {
          const std::size_t i = near_keypoint(digit_.digit(), mine);
          const std::size_t j = near_keypoint(other->digit(), its);
          const double room =
              axis_distance({keypoints[i], keypoints[i + 1]}, {keypoints[j], keypoints[j + 1]}) -
              digit_.radius(mine) - other->radius(its) + kSqueeze;
          cost += kOverlapWeight * square(std::min(0.0, room) / kMillimetre);
        }
      }
    }
    return cost;
  }

  const HandModel& hand_;
  const DigitSurface& digit_;
  const std::vector<const DigitSurface*>& others_;
  const DigitGoal& goal_;
  const PlacedObject& object_;
};

// One angle alone, or two together, either way.
std::vector<Eigen::Vector4d> search_directions() {
  std::vector<Eigen::Vector4d> directions;
  for (int i = 0; i < 4; ++i) {
    for (const double way : {1.0, -1.0}) {
      directions.push_back(way * Eigen::Vector4d::Unit(i));
      for (int j = i + 1; j < 4; ++j) {
        directions.push_back(way * (Eigen::Vector4d::Unit(i) + Eigen::Vector4d::Unit(j)));
        directions.push_back(way * (Eigen::Vector4d::Unit(i) - Eigen::Vector4d::Unit(j)));
      }
    }
  }
  return directions;
}

struct Found {
  JointAngles angles;
  double cost = 0.0;
};

// Takes each direction in turn as far as it improves, and halves the step when none does.
Found compass_search(const ClosingCost& cost, int digit, const JointAngles& angles) {
  static const std::vector<Eigen::Vector4d> kDirections = search_directions();
  const Eigen::Vector4d lower = angle_limits().lower.segment<4>(4 * digit);
  const Eigen::Vector4d upper = angle_limits().upper.segment<4>(4 * digit);
  Found best{angles, cost.at(angles)};
  const auto improves = [&](const Eigen::Vector4d& step) {
    JointAngles tried = best.angles;
    tried.segment<4>(4 * digit) =
        (tried.segment<4>(4 * digit) + step).cwiseMax(lower).cwiseMin(upper);
    const double tried_cost = cost.at(tried);
    if (tried_cost >= best.cost - 1e-6) return false;
    best = {tried, tried_cost};
    return true;
  };
  for (double step = 8.0 * kDegree; step > 0.2 * kDegree; step *= 0.5) {
    bool moved = true;
    while (moved) {
      moved = false;
      for (const Eigen::Vector4d& direction : kDirections) {
        while (improves(step * direction)) moved = true;
      }
    }
  }
  return best;
}

}  // namespace

DigitSurface::DigitSurface(const HandModel& hand, int digit) : hand_(&hand), digit_(digit) {
  constexpr double kBallOfThumb = 0.35;  // of the first bone: skin that gives way as the palm's
  const auto zero_from_rest = bone_transforms(hand.skeleton, hand.rest_angles);
  std::array<int, 3> counts = {};
  for (std::size_t i = 0; i < hand.links.size(); ++i) {
    const int bone = main_bone(hand.links[i]);
    if (bone == 0 || (bone - 1) / 3 != digit) continue;
    Vertex vertex{(bone - 1) % 3, {}, hand.links[i]};
    for (std::size_t k = 0; k < vertex.at_zero.size(); ++k) {
      const auto link_bone = static_cast<std::size_t>(vertex.links.bones[k]);
      vertex.at_zero[k] = zero_from_rest[link_bone].inverse() * hand.rest_surface.vertices[i];
    }
    const auto main_link = static_cast<std::size_t>(
        std::max_element(vertex.links.weights.begin(), vertex.links.weights.end()) -
        vertex.links.weights.begin());
    const std::size_t near = near_keypoint(digit, vertex.bone_of_digit);
    const Eigen::Vector3d along = hand.skeleton.keypoints[near + 1] - hand.skeleton.keypoints[near];
    const Eigen::Vector3d out = vertex.at_zero[main_link] - hand.skeleton.keypoints[near];
    const double share = out.dot(along) / along.squaredNorm();
    if (share > 0.2 && share < 0.8) {
      radii_[static_cast<std::size_t>(vertex.bone_of_digit)] += (out - share * along).norm();
      ++counts[static_cast<std::size_t>(vertex.bone_of_digit)];
    }
    if (digit > 0 || vertex.bone_of_digit > 0 || share > kBallOfThumb) vertices_.push_back(vertex);
  }
  for (std::size_t bone = 0; bone < 3; ++bone) radii_[bone] /= std::max(counts[bone], 1);
}

std::array<double, 3> DigitSurface::clearances(const JointAngles& angles,
                                               const PlacedObject& object) const {
  const auto hand_from_zero = bone_transforms(hand_->skeleton, angles);
  const Rigid3d object_from_hand = object.object_from_hand();
  std::array<Eigen::Affine3d, kBoneCount> object_from_zero;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const Rigid3d transform = object_from_hand * hand_from_zero[bone];
    object_from_zero[bone] = Eigen::Translation3d(transform.translation) * transform.rotation;
  }
  std::array<double, 3> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (const Vertex& vertex : vertices_) {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < vertex.at_zero.size(); ++k) {
      const double weight = vertex.links.weights[k];
      if (weight == 0.0) continue;
      point += weight * (object_from_zero[static_cast<std::size_t>(vertex.links.bones[k])] *
                         vertex.at_zero[k]);
    }
    double& clearance = least[static_cast<std::size_t>(vertex.bone_of_digit)];
    clearance = std::min(clearance, signed_distance(object.object, point));
  }
  return least;
}

JointAngles closed_digit(const HandModel& hand, const DigitSurface& digit,
                         const std::vector<const DigitSurface*>& others, const DigitGoal& goal,
                         const PlacedObject& object, const JointAngles& angles) {
  const ClosingCost cost(hand, digit, others, goal, object);
  const int first = 4 * digit.digit();
  Found best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const double share : {1.0, 0.2}) {
    JointAngles start = angles;
    start.segment<4>(first) = goal.preferred;
    start.segment<3>(first + 1) *= share;
    start.segment<4>(first) = start.segment<4>(first)
                                  .cwiseMax(angle_limits().lower.segment<4>(first))
                                  .cwiseMin(angle_limits().upper.segment<4>(first));
    const Found found = compass_search(cost, digit.digit(), start);
    if (found.cost < best.cost) best = found;
  }
  return best.angles;
}

}  // namespace tegata
