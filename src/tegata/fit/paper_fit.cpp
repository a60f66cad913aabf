// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/paper_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/stopwatch.h"
#include "tegata/fit/start.h"
#include "tegata/fit/surface_row.h"
#include "tegata/hand/posed_rows.h"
#include "tegata/math/robust_kernel.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr double kHandRadius = 0.07;  // about the hand's centre [m], so that turns weigh as shifts

TriangleMesh proven_part(const TriangleMesh& hull) {
  TriangleMesh proven = hull;
  if (hull.unproven.empty()) return proven;
  std::erase_if(proven.triangles, [&hull](const Triangle& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [&hull](std::uint32_t vertex) { return hull.unproven[vertex] != 0; });
  });
  if (proven.triangles.empty()) throw Error("hull: no triangle is proven by the silhouettes");
  return proven;
}

// IV-A: r_i is the point of the hull closest to the model's vertex m_i, found anew whenever the
// energy is asked for; E = sum of rho(|m_i - r_i|). Calls on_pair(vertex, m_i - r_i, weight) and
// returns E over the number of vertices.
template <typename OnPair>
double sum_over_vertices(const PaperEnergy& energy, const PosedHand& posed, const OnPair& on_pair) {
  const LorentzianKernel kernel(energy.sigma);
  double sum = 0.0;
  for (const std::uint32_t i : energy.hand.samples) {
    const NearestSurface::Match match = energy.frame.surface.nearest(posed.vertices()[i]);
    sum += kernel.cost(match.distance);
    on_pair(i, posed.vertices()[i] - match.point, kernel.weight(match.distance));
  }
  return sum / static_cast<double>(energy.hand.samples.size());
}

Eigen::Vector3d center_of(const FitHand& hand, const HandPose& pose) {
  return pose.world_from_hand * hand.model->skeleton.keypoints[kMiddleMcp];
}

// The energy of one frame as conjugate_gradient() wants it: p with theta fixed.
struct PoseProblem {
  const PaperEnergy& energy;

  EnergySlope evaluate(const HandPose& pose) const { return energy.by_pose(pose); }
  HandPose advanced(const HandPose& pose, const Eigen::VectorXd& step) const {
    return energy.moved(pose, step);
  }
};

// And of all frames: theta with every p_k fixed (V-A: the sum over the frames).
struct AngleProblem {
  std::span<const PaperEnergy> energies;
  const std::vector<Rigid3d>& world_from_hand;
  int threads;

  EnergySlope evaluate(const JointAngles& angles) const {
    std::vector<EnergySlope> of_frames(energies.size());
    parallel_for(energies.size(), threads, [&](std::size_t k) {
      of_frames[k] = energies[k].by_angles({world_from_hand[k], angles});
    });
    EnergySlope sum{0.0, Eigen::VectorXd::Zero(kAngleCount)};
    for (const EnergySlope& of_frame : of_frames) {
      sum.energy += of_frame.energy;
      sum.gradient += of_frame.gradient;
    }
    const AngleLimits& limits = angle_limits();
    for (int k = 0; k < kAngleCount; ++k) {
      const bool is_held = (angles[k] >= limits.upper[k] && sum.gradient[k] < 0.0) ||
                           (angles[k] <= limits.lower[k] && sum.gradient[k] > 0.0);
      if (is_held) sum.gradient[k] = 0.0;
    }
    return sum;
  }
  JointAngles advanced(const JointAngles& angles, const Eigen::VectorXd& step) const {
    return (angles + step).cwiseMax(angle_limits().lower).cwiseMin(angle_limits().upper);
  }
};

struct Settling {
  double energy = std::numeric_limits<double>::infinity();
  int alternations = 0;
  bool is_settled = false;
};

// IV-B, steps 2 to 9, and with more than one frame V-A, steps 4 to 7: p (each p_k) by conjugate
// gradients with theta fixed, then theta with p fixed, until the energy settles.
Settling settle(std::span<const PaperEnergy> energies, const PaperFitOptions& options,
                HandEstimate& estimate) {
  Settling settling;
  while (!settling.is_settled && settling.alternations < options.most_alternations) {
    ++settling.alternations;
    parallel_for(energies.size(), options.threads, [&](std::size_t k) {
      HandPose pose = estimate.pose(k);
      conjugate_gradient(PoseProblem{energies[k]}, options.minimisation, pose);
      estimate.world_from_hand[k] = pose.world_from_hand;
    });
    const double energy =
        conjugate_gradient(AngleProblem{energies, estimate.world_from_hand, options.threads},
                           options.minimisation, estimate.angles);
    settling.is_settled = settling.energy - energy < options.energy_tolerance * energy;
    settling.energy = energy;
  }
  return settling;
}

std::vector<PaperEnergy> energies_of(const FitHand& hand, std::span<const PaperFrame> frames,
                                     double sigma) {
  std::vector<PaperEnergy> energies;
  for (const PaperFrame& frame : frames) energies.push_back({hand, frame, sigma * hand.scale});
  return energies;
}

// The same at one sigma after the other.
Settling settle_from_coarse_to_fine(const FitHand& hand, std::span<const PaperFrame> frames,
                                    const PaperFitOptions& options, HandEstimate& estimate) {
  Settling last;
  int alternations = 0;
  for (const double sigma : options.sigmas) {
    last = settle(energies_of(hand, frames, sigma), options, estimate);
    alternations += last.alternations;
  }
  last.alternations = alternations;
  return last;
}

// IV-B, step 1: the rough initial pose. From landmarks, or from the hull's ends where there are
// none; of a few typical grasps that which lies closest to the hull.
HandPose rough_pose(const FitHand& hand, const PaperFrame& first, const PaperFitOptions& options) {
  std::vector<HandPose> starts = starts_from_nothing(hand, *first.frame, typical_angles());
  const std::vector<PaperEnergy> energy =
      energies_of(hand, std::span(&first, 1), options.sigmas.front());
  std::vector<double> reached(starts.size());
  parallel_for(starts.size(), options.threads, [&](std::size_t i) {
    reached[i] = conjugate_gradient(PoseProblem{energy.front()}, options.minimisation, starts[i]);
  });
  return starts[static_cast<std::size_t>(std::min_element(reached.begin(), reached.end()) -
                                         reached.begin())];
}

// V-A, steps 1 and 2: each frame on its own, from the one before.
void fit_single_frames(const FitHand& hand, std::span<const PaperFrame> frames,
                       const PaperFitOptions& options, const Observer& observer, PaperFit& fit) {
  HandPose pose = rough_pose(hand, frames.front(), options);
  bool is_settled = true;
  for (const PaperFrame& frame : frames) {
    observer.progress("frames", fit.single_poses.size(), frames.size());
    HandEstimate estimate{pose.angles, {pose.world_from_hand}};
    const Settling settling =
        settle_from_coarse_to_fine(hand, std::span(&frame, 1), options, estimate);
    pose = estimate.pose(0);
    fit.single_poses.push_back(pose);
    fit.alternations += settling.alternations;
    is_settled = is_settled && settling.is_settled;
  }
  observer.progress("frames", frames.size(), frames.size());
  fit.termination = is_settled ? Termination::converged : Termination::iteration_limit;
}

// V-A, step 3: theta is the mean over the frames.
void average_angles(PaperFit& fit) {
  const double count = static_cast<double>(fit.single_poses.size());
  fit.angles.setZero();
  for (const HandPose& pose : fit.single_poses) fit.angles += pose.angles / count;
  JointAngles variance = JointAngles::Zero();
  for (const HandPose& pose : fit.single_poses) {
    variance += (pose.angles - fit.angles).cwiseAbs2() / count;
  }
  fit.spread = variance.cwiseSqrt();
}

// V-A, steps 4 to 7: all p_k and theta in turn.
void fit_simultaneously(const FitHand& hand, std::span<const PaperFrame> frames,
                        const PaperFitOptions& options, PaperFit& fit) {
  HandEstimate estimate{fit.angles, {}};
  for (const HandPose& pose : fit.single_poses) {
    estimate.world_from_hand.push_back(pose.world_from_hand);
  }
  const Settling settling = settle_from_coarse_to_fine(hand, frames, options, estimate);
  fit.alternations += settling.alternations;
  fit.termination = settling.is_settled ? Termination::converged : Termination::iteration_limit;
  fit.angles = estimate.angles;
  for (std::size_t k = 0; k < frames.size(); ++k) fit.poses[k] = estimate.pose(k);
}

BoneWeights bone_weights(const PaperEnergy& energy, const HandPose& pose) {
  BoneWeights sums = {}, counts = {};
  sum_over_vertices(
      energy, energy.hand.posed(pose), [&](std::uint32_t i, const Eigen::Vector3d&, double weight) {
        const auto bone = static_cast<std::size_t>(main_bone(energy.hand.model->links[i]));
        sums[bone] += weight;
        counts[bone] += 1.0;
      });
  for (std::size_t bone = 0; bone < sums.size(); ++bone) {
    if (counts[bone] > 0.0) sums[bone] /= counts[bone];
  }
  return sums;
}

}  // namespace

PaperFrame::PaperFrame(std::shared_ptr<const FitFrame> known, const TriangleMesh& hull)
    : frame(std::move(known)), surface(proven_part(hull)) {}

EnergySlope PaperEnergy::by_pose(const HandPose& pose) const {
  const PosedHand posed = hand.posed(pose);
  const Eigen::Vector3d center = center_of(hand, pose);
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), shift = Eigen::Vector3d::Zero();
  EnergySlope slope;
  slope.energy = sum_over_vertices(
      *this, posed, [&](std::uint32_t i, const Eigen::Vector3d& difference, double weight) {
        const Eigen::Vector3d pull = weight * difference;
        turn += (posed.vertices()[i] - center).cross(pull);
        shift += pull;
      });
  slope.gradient.resize(kPoseParameterCount);
  slope.gradient << turn, kHandRadius * hand.scale * shift;
  slope.gradient /= static_cast<double>(hand.samples.size());
  return slope;
}

EnergySlope PaperEnergy::by_angles(const HandPose& pose) const {
  const PosedHand posed = hand.posed(pose);
  HandRow row;
  EnergySlope slope;
  slope.energy = sum_over_vertices(
      *this, posed, [&](std::uint32_t i, const Eigen::Vector3d& difference, double weight) {
        add_vertex_row(posed, i, weight * difference, row);
      });
  slope.gradient =
      row.values.tail<kAngleCount>().transpose() / static_cast<double>(hand.samples.size());
  return slope;
}

HandPose PaperEnergy::moved(const HandPose& pose, const Eigen::VectorXd& step) const {
  HandPose next = pose;
  next.world_from_hand =
      rotation_about(center_of(hand, pose), step.head<3>()) * pose.world_from_hand;
  next.world_from_hand.translation += kHandRadius * hand.scale * step.tail<3>();
  return next;
}

PaperFit fit_paper(const FitHand& hand, std::span<const PaperFrame> frames,
                   const PaperFitOptions& options, const Observer& observer) {
  if (frames.empty()) throw Error("paper fit: got no frame, expected at least one");
  PaperFit fit;
  const Stopwatch frame_watch;
  fit_single_frames(hand, frames, options, observer, fit);
  fit.poses = fit.single_poses;
  average_angles(fit);
  fit.frame_seconds = frame_watch.seconds();
  const Stopwatch all_watch;
  if (options.grasp == GraspConstraint::fixed) {
    observer.progress("all frames", 0, 1);
    fit_simultaneously(hand, frames, options, fit);
    observer.progress("all frames", 1, 1);
  }
  fit.all_frames_seconds = all_watch.seconds();
  const std::vector<PaperEnergy> energies = energies_of(hand, frames, options.sigmas.back());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    fit.weights.push_back(bone_weights(energies[k], fit.poses[k]));
  }
  return fit;
}

}  // namespace tegata
