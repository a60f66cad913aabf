// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/calibration_suspicion.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>

#include "tegata/base/angle.h"
#include "tegata/base/text.h"
#include "tegata/calibrate/tangency.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

// Below it tangent planes agree as well as silhouettes of a real hand let them.
constexpr double kAgreement = 1.2 * kDegree;
// Where less is contradicted, only what explains nearly all of it is believed, and turns only from
// this one on.
constexpr double kFaint = 0.25 * kDegree;
constexpr double kFaintlyExplained = 0.4;
constexpr double kLeastTurn = 2.0 * kDegree;
// A turn explains three tangents whatever they are: so few prove only what is far off.
constexpr std::size_t kFewTangents = 5, kFewestTangents = 3;
constexpr double kFarOff = 3.0 * kDegree;
// What a calibration by which no tangents are left counts as.
constexpr double kMostContradicted = 30.0 * kDegree;
// What puts things right must explain so much of the contradiction.
constexpr double kExplained = 0.5;
// Several cameras are named where each explains about as much. Of two cameras, which of them was
// turned can hardly be told: all that explain enough are named.
constexpr double kTie = 1.25, kTieOfTwo = 4.0;

// How well silhouettes and a rig agree.
struct Agreement {
  double cost = 0.0;         // [rad]
  std::size_t tangents = 0;  // it was measured by
};

struct Hypothesis {
  std::vector<std::size_t> cameras;
  std::string message;
  Agreement agreement;
  double handicap = 1.0;  ///< of those that can be fitted to anything
  bool is_turn = false;
  double lack = 1.0;  ///< of tangents, as a factor
};

Eigen::Vector3d middle_ray(const OutlineRays& outline) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& ray : outline.rays) sum += ray;
  return sum.normalized();
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool is_cut(const std::optional<OutlineRays>& outline) {
  return outline && std::find(outline->cut.begin(), outline->cut.end(), true) != outline->cut.end();
}

// How far a camera's middle ray passes by where those of two or more others meet, beyond what
// different outlines of one thing explain [rad]; nothing where it cannot be told.
std::optional<double> miss(const CameraRig& rig,
                           const std::vector<std::optional<OutlineRays>>& frame,
                           std::size_t camera) {
  // Of the silhouette's radius; more where pictures end at different places of an arm.
  constexpr double kShare = 0.2, kShareOfCut = 0.6;
  if (!frame[camera]) return std::nullopt;
  auto others = frame;
  others[camera].reset();
  const std::optional<Eigen::Vector3d> point = meeting_point(rig, others);
  if (!point) return std::nullopt;
  const Eigen::Vector3d middle = middle_ray(*frame[camera]);
  double radius = 0.0;
  for (const Eigen::Vector3d& ray : frame[camera]->rays) {
    radius = std::max(radius, angle_between(ray, middle));
  }
  const double off = angle_between(rig[camera].camera_from_world * *point, middle);
  const bool cut = std::any_of(frame.begin(), frame.end(), is_cut);
  return std::max(0.0, off - (cut ? kShareOfCut : kShare) * radius);
}

// The mean over the cameras of the median of their misses.
double miss_cost(const CameraRig& rig, const RigOutlines& frames) {
  constexpr double kMost = 30.0 * kDegree;
  double sum = 0.0;
  for (std::size_t c = 0; c < rig.size() && rig.size() > 2; ++c) {
    std::vector<double> misses;
    for (const auto& frame : frames) {
      if (const std::optional<double> off = miss(rig, frame, c)) misses.push_back(*off);
    }
    if (misses.empty()) continue;
    const auto middle = misses.begin() + static_cast<std::ptrdiff_t>(misses.size() / 2);
    std::nth_element(misses.begin(), middle, misses.end());
    sum += std::min(*middle, kMost) / static_cast<double>(rig.size());
  }
  return sum;
}

std::size_t tangents_of(const std::vector<PairTangency>& pairs) {
  std::size_t count = 0;
  for (const PairTangency& pair : pairs) count += pair.count;
  return count;
}

Agreement agreement_of(const CameraRig& rig, const RigOutlines& frames) {
  const std::vector<PairTangency> pairs = pair_tangencies(rig, frames);
  return {tangency_cost(pairs) + miss_cost(rig, frames), tangents_of(pairs)};
}

// Costs that differ by less than pixels explain do not matter.
double rank(const Hypothesis& hypothesis) {
  constexpr double kNoise = 0.2 * kDegree;
  return (hypothesis.agreement.cost + kNoise) * hypothesis.handicap * hypothesis.lack;
}

// A rig by which the silhouettes have hardly any tangents agrees with anything: such hypotheses
// fall behind, those without any are none.
void weigh_by_tangents(std::vector<Hypothesis>& hypotheses) {
  constexpr double kEnough = 0.75;  // of the most that a hypothesis has
  hypotheses.erase(
      std::remove_if(hypotheses.begin(), hypotheses.end(),
                     [](const Hypothesis& one) { return one.agreement.tangents == 0; }),
      hypotheses.end());
  std::size_t most = 0;
  for (const Hypothesis& one : hypotheses) most = std::max(most, one.agreement.tangents);
  for (Hypothesis& one : hypotheses) {
    one.lack = std::max(
        1.0, kEnough * static_cast<double>(most) / static_cast<double>(one.agreement.tangents));
  }
}

std::string degrees(double angle) {
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(1) << angle / kDegree;
  return stream.str();
}

// Exchanged pictures, with the poses that belong to them.
void try_exchanges(const CameraRig& rig, const RigOutlines& frames,
                   std::vector<Hypothesis>& hypotheses) {
  for (std::size_t a = 0; a < rig.size(); ++a) {
    for (std::size_t b = a + 1; b < rig.size(); ++b) {
      CameraRig exchanged = rig;
      std::swap(exchanged[a].camera_from_world, exchanged[b].camera_from_world);
      hypotheses.push_back(
          {{a, b},
           text("cameras '", rig[a].name, "' and '", rig[b].name, "' seem to be exchanged"),
           agreement_of(exchanged, frames)});
    }
  }
}

RigOutlines flipped(RigOutlines frames, std::size_t camera, const Eigen::Vector3d& signs) {
  for (auto& frame : frames) {
    if (!frame[camera]) continue;
    for (Eigen::Vector3d& ray : frame[camera]->rays) ray = ray.cwiseProduct(signs);
  }
  return frames;
}

void try_flips(const CameraRig& rig, const RigOutlines& frames,
               std::vector<Hypothesis>& hypotheses) {
  struct Flip {
    Eigen::Vector3d signs;
    std::string_view what;
  };
  const std::array<Flip, 3> flips = {{{{-1, 1, 1}, "mirrored left to right"},
                                      {{1, -1, 1}, "mirrored top to bottom"},
                                      {{-1, -1, 1}, "upside down"}}};
  for (std::size_t c = 0; c < rig.size(); ++c) {
    for (const Flip& flip : flips) {
      hypotheses.push_back({{c},
                            text("the pictures of camera '", rig[c].name, "' seem to be ",
                                 flip.what, ", or its pose is"),
                            agreement_of(rig, flipped(frames, c, flip.signs))});
    }
  }
}

// One camera's pose in a frame of the other handedness: world and camera mirrored alike.
void try_mirrored_poses(const CameraRig& rig, const RigOutlines& frames,
                        std::vector<Hypothesis>& hypotheses) {
  constexpr double kHandicap = 1.2;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      CameraRig mirrored = rig;
      Rigid3d& pose = mirrored[c].camera_from_world;
      // The mirror image of a rotation vector turns the other way about the mirror's axes.
      Eigen::Vector3d turn = -so3_log(pose.rotation.normalized());
      turn[axis] = -turn[axis];
      pose.rotation = so3_exp(turn);
      pose.translation[axis] = -pose.translation[axis];
      hypotheses.push_back(
          {{c},
           text("the pose of camera '", rig[c].name, "' seems to be mirrored in ", "xyz"[axis]),
           agreement_of(mirrored, frames),
           kHandicap});
    }
  }
}

void try_inverse(const CameraRig& rig, const RigOutlines& frames,
                 std::vector<Hypothesis>& hypotheses) {
  CameraRig inverse = rig;
  std::vector<std::size_t> all;
  for (Camera& camera : inverse) {
    camera.camera_from_world = camera.camera_from_world.inverse();
    all.push_back(all.size());
  }
  hypotheses.push_back({all, "the poses seem to take camera to world, expected world to camera",
                        agreement_of(inverse, frames)});
}

// The turn of one camera about its centre that fits the others best: a pattern search, as medians
// have no derivatives.
Eigen::Vector3d best_turn(const CameraRig& rig, const RigOutlines& frames, std::size_t camera,
                          const Agreement& unturned) {
  constexpr double kFirstStep = 4.0 * kDegree, kLastStep = 0.2 * kDegree, kMost = 20.0 * kDegree;
  CameraRig turned = rig;
  const auto cost = [&](const Eigen::Vector3d& turn) {
    const Rigid3d& pose = rig[camera].camera_from_world;
    const Eigen::Quaterniond by = so3_exp(turn);
    turned[camera].camera_from_world = {by * pose.rotation, by * pose.translation};
    const Agreement found = agreement_of(turned, frames);
    // Not by turning tangents out of sight.
    return 2 * found.tangents >= unturned.tangents ? found.cost
                                                   : std::numeric_limits<double>::infinity();
  };
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least = unturned.cost;
  for (double step = kFirstStep; step >= kLastStep;) {
    Eigen::Vector3d next = best;
    double next_cost = least;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector3d turn = best + sign * step * Eigen::Vector3d::Unit(axis);
        if (turn.norm() > kMost) continue;
        const double found = cost(turn);
        if (found < next_cost) {
          next = turn;
          next_cost = found;
        }
      }
    }
    if (next_cost < least) {
      best = next;
      least = next_cost;
    } else {
      step *= 0.5;
    }
  }
  return best;
}

void try_turns(const CameraRig& rig, const RigOutlines& frames, const Agreement& unturned,
               std::vector<Hypothesis>& hypotheses) {
  constexpr double kHandicap = 1.5;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    const Eigen::Vector3d turn = best_turn(rig, frames, c, unturned);
    if (turn.norm() < kLeastTurn) continue;
    CameraRig turned = rig;
    const Eigen::Quaterniond by = so3_exp(turn);
    Rigid3d& pose = turned[c].camera_from_world;
    pose = {by * pose.rotation, by * pose.translation};
    hypotheses.push_back({{c},
                          text("camera '", rig[c].name, "' does not fit the others: turned by ",
                               degrees(turn.norm()), " degrees it would"),
                          agreement_of(turned, frames),
                          kHandicap,
                          true});
  }
}

// The others must agree without it, and there must be two others.
void try_without(const CameraRig& rig, const RigOutlines& frames,
                 std::vector<Hypothesis>& hypotheses) {
  constexpr double kHandicap = 2.0;
  for (std::size_t c = 0; c < rig.size() && rig.size() > 2; ++c) {
    RigOutlines left = frames;
    for (auto& frame : left) frame[c].reset();
    Agreement agreement = agreement_of(rig, left);
    agreement.tangents = agreement.tangents * rig.size() / (rig.size() - 2);  // had it its pairs
    hypotheses.push_back(
        {{c},
         text("camera '", rig[c].name, "' does not fit the others, which agree with each other"),
         agreement,
         kHandicap});
  }
}

// What contradicts what: the pair of cameras that agree least.
std::string contradiction(const CameraRig& rig, const std::vector<PairTangency>& pairs) {
  if (pairs.empty()) {
    return "by the calibration each camera stands in or near the others' silhouettes";
  }
  const PairTangency& worst = *std::max_element(
      pairs.begin(), pairs.end(),
      [](const PairTangency& a, const PairTangency& b) { return a.median < b.median; });
  return text("the silhouettes contradict the calibration, those of '", rig[worst.first].name,
              "' and '", rig[worst.second].name, "' by ", degrees(worst.median), " degrees");
}

// The best hypothesis, which comes first, and those of the same kind that are about as good.
Suspicion suspicion_of(const CameraRig& rig, const std::vector<PairTangency>& pairs,
                       const std::vector<Hypothesis>& hypotheses, double cost_before) {
  const Hypothesis& best = hypotheses.front();
  Suspicion suspicion{{}, contradiction(rig, pairs), cost_before, best.agreement.cost};
  if (best.agreement.cost > kExplained * cost_before) {
    for (const Camera& camera : rig) suspicion.cameras.push_back(camera.name);
    suspicion.message +=
        ": it is not that of these pictures, they are not of the same moments, or show different "
        "things";
    return suspicion;
  }
  const bool turn_of_two = rig.size() == 2 && best.is_turn;
  for (const Hypothesis& hypothesis : hypotheses) {
    const bool first = &hypothesis == &best;
    const bool tie = hypothesis.is_turn == best.is_turn && hypothesis.handicap == best.handicap &&
                     rank(hypothesis) <= (turn_of_two ? kTieOfTwo : kTie) * rank(best) &&
                     hypothesis.agreement.cost <= kExplained * cost_before &&
                     hypothesis.cameras.size() == best.cameras.size();
    if (!first && !tie) continue;
    suspicion.message += (first ? ": " : "; or ") + hypothesis.message;
    for (const std::size_t c : hypothesis.cameras) {
      const std::string& name = rig[c].name;
      if (std::find(suspicion.cameras.begin(), suspicion.cameras.end(), name) ==
          suspicion.cameras.end()) {
        suspicion.cameras.push_back(name);
      }
    }
  }
  return suspicion;
}

}  // namespace

std::optional<Suspicion> suspect(const CameraRig& rig, const RigOutlines& frames) {
  const std::vector<PairTangency> pairs = pair_tangencies(rig, frames);
  const double missed = miss_cost(rig, frames);
  const Agreement now = {tangency_cost(pairs) + missed, tangents_of(pairs)};
  const bool agree = !pairs.empty() && missed <= kAgreement &&
                     std::all_of(pairs.begin(), pairs.end(), [](const PairTangency& pair) {
                       return pair.median <= kAgreement;
                     });
  const double cost = pairs.empty() ? kMostContradicted : now.cost;
  if (cost < kFaint) return std::nullopt;
  const bool few = now.tangents < (cost < kFarOff ? kFewTangents : kFewestTangents);
  std::vector<Hypothesis> hypotheses;
  try_exchanges(rig, frames, hypotheses);
  try_flips(rig, frames, hypotheses);
  try_mirrored_poses(rig, frames, hypotheses);
  try_inverse(rig, frames, hypotheses);
  if (!few) try_turns(rig, frames, now, hypotheses);
  // Two cameras that are left always meet: they prove nothing against faint doubts.
  if (!agree) try_without(rig, frames, hypotheses);
  weigh_by_tangents(hypotheses);
  if (hypotheses.empty()) return std::nullopt;
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return rank(a) < rank(b); });
  // Cameras that face each other have no tangents either: only what agrees in all frames tells.
  const Agreement& best = hypotheses.front().agreement;
  if (pairs.empty() && (best.cost > kAgreement || best.tangents < frames.size())) {
    return std::nullopt;
  }
  if ((agree || few) && best.cost > kFaintlyExplained * cost) return std::nullopt;
  if (few && cost < kFarOff && best.tangents < kFewTangents) return std::nullopt;
  return suspicion_of(rig, pairs, hypotheses, cost);
}

std::optional<Eigen::Vector3d> meeting_point(const CameraRig& rig,
                                             const std::vector<std::optional<OutlineRays>>& frame) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t c = 0; c < rig.size(); ++c) {
    if (!frame[c]) continue;
    const Eigen::Vector3d ray =
        rig[c].camera_from_world.rotation.conjugate() * middle_ray(*frame[c]);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - ray * ray.transpose();
    sum += across;
    right += across * rig[c].center_in_world();
  }
  if (std::abs(sum.determinant()) < 1e-6) return std::nullopt;
  const Eigen::Vector3d point = sum.inverse() * right;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    if (frame[c] && (rig[c].camera_from_world * point).z() <= 0.0) return std::nullopt;
  }
  return point;
}

}  // namespace tegata
