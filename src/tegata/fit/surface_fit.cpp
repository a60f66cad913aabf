// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "tegata/fit/surface_fit_target.h"
#include "tegata/math/robust_kernel.h"

namespace tegata {
namespace {

constexpr int kCount = kHandParameterCount + kShapeParameterCount;
using Vector = Eigen::Matrix<double, kCount, 1>;
using Matrix = Eigen::Matrix<double, kCount, kCount>;
using Row = Eigen::Matrix<double, 1, kCount>;
using Jacobian = Eigen::Matrix<double, 3, kCount>;

constexpr double kLeastAgreement = 0.3;    // cosine between the normals of a pair
constexpr double kLimitDeviation = 0.05;   // of angles beyond their limits [rad]
constexpr double kTurn = 0.3;              // longest turn of a step [rad]
constexpr double kEnergyTolerance = 1e-6;  // relative gain of a step that is no change
constexpr double kMostDamping = 1e6;
constexpr int kKeypointIterations = 25;

double square(double x) { return x * x; }
std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Estimate {
  HandPose pose;
  ShapeParameters shape = shape_prior().mean;
};

struct Equations {
  Matrix hessian = Matrix::Zero();
  Vector gradient = Vector::Zero();
  double cost = 0.0;

  void add(double residual, const Row& row, double weight, double residual_cost) {
    hessian.selfadjointView<Eigen::Lower>().rankUpdate(row.transpose(), weight);
    gradient += weight * residual * row.transpose();
    cost += residual_cost;
  }
  /// One of a parameter alone, in standard deviations.
  void add_single(int parameter, double residual, double deviation) {
    hessian(parameter, parameter) += 1.0 / square(deviation);
    gradient[parameter] += residual / square(deviation);
    cost += 0.5 * square(residual / deviation);
  }
};

/// The hand at an estimate.
class TrialHand {
 public:
  TrialHand(const ShapedHand& hand, const Estimate& estimate)
      : model_(hand.model(shape_from_parameters(estimate.shape))),
        basis_(hand.basis(estimate.shape)),
        posed_(model_, estimate.pose),
        shape_(model_, basis_, estimate.pose) {}
  TrialHand(const TrialHand&) = delete;
  TrialHand& operator=(const TrialHand&) = delete;

  const PosedHand& posed() const { return posed_; }
  const HandModel& model() const { return model_; }
  Jacobian vertex_jacobian(std::size_t vertex) const {
    Jacobian jacobian;
    jacobian << posed_.vertex_jacobian(vertex), shape_.vertex_jacobian(vertex);
    return jacobian;
  }
  Jacobian keypoint_jacobian(int keypoint) const {
    Jacobian jacobian;
    jacobian << posed_.keypoint_jacobian(keypoint), shape_.keypoint_jacobian(keypoint);
    return jacobian;
  }

 private:
  HandModel model_;
  ShapeBasis basis_;
  PosedHand posed_;
  PosedShape shape_;
};

/// Adds pairs of a point of the hand and one of the target, along one's normal.
class PairSum {
 public:
  PairSum(const SurfaceFitOptions& options, std::size_t count, Equations& equations)
      : sigma_(options.sigma),
        kernel_(options.sigma),
        precision_(0.5 * options.point_count /
                   (static_cast<double>(std::max<std::size_t>(count, 1)) *
                    square(options.surface_deviation))),
        equations_(&equations) {}

  void add(const Eigen::Vector3d& difference, const Eigen::Vector3d& normal,
           const Jacobian& jacobian) {
    const double distance = difference.norm();
    equations_->add(normal.dot(difference), normal.transpose() * jacobian,
                    precision_ * kernel_.weight(distance), precision_ * kernel_.cost(distance));
  }
  /// A pair without a meaning costs what one at sigma costs, so that nothing is won by losing it.
  void add_unmatched() { equations_->cost += precision_ * kernel_.cost(sigma_); }

 private:
  double sigma_;
  LorentzianKernel kernel_;
  double precision_;
  Equations* equations_;
};

void add_surface_terms(const TrialHand& hand, const SurfaceFitTarget& target,
                       const std::vector<SurfacePoint>& samples, const SurfaceFitOptions& options,
                       Equations& equations) {
  const TriangleMesh surface = hand.posed().surface();
  const auto jacobian_at = [&](const SurfacePoint& point) {
    const Triangle& corners = surface.triangles[point.triangle];
    return Jacobian(point.corners[0] * hand.vertex_jacobian(corners[0]) +
                    point.corners[1] * hand.vertex_jacobian(corners[1]) +
                    point.corners[2] * hand.vertex_jacobian(corners[2]));
  };
  PairSum towards_target(options, samples.size(), equations);
  for (const SurfacePoint& sample : samples) {
    const Eigen::Vector3d point = place_on(surface, sample);
    if (!target.is_beyond_wrist(point)) continue;
    const NearestSurface::Match match = target.nearest().nearest(point);
    const Eigen::Vector3d normal = triangle_normal(target.surface(), match.triangle);
    const Eigen::Vector3d own = triangle_normal(surface, sample.triangle);
    if (normal.dot(own) < kLeastAgreement) {
      towards_target.add_unmatched();
    } else {
      towards_target.add(point - match.point, normal, jacobian_at(sample));
    }
  }
  const NearestSurface nearest(surface);
  PairSum towards_hand(options, target.points().size(), equations);
  for (std::size_t i = 0; i < target.points().size(); ++i) {
    const NearestSurface::Match match = nearest.nearest(target.points()[i]);
    const Eigen::Vector3d normal = triangle_normal(surface, match.triangle);
    if (normal.dot(target.normals()[i]) < kLeastAgreement) {
      towards_hand.add_unmatched();
    } else {
      towards_hand.add(match.point - target.points()[i], normal,
                       jacobian_at(point_of_triangle(surface, match.triangle, match.point)));
    }
  }
}

void add_keypoints(const TrialHand& hand, const SurfaceFitTarget& target, double deviation,
                   Equations& equations) {
  for (int k = 0; k < kKeypointCount; ++k) {
    const Eigen::Vector3d difference =
        hand.posed().keypoints()[index(k)] - target.keypoints()[index(k)];
    const Jacobian jacobian = hand.keypoint_jacobian(k);
    for (int axis = 0; axis < 3; ++axis) {
      equations.add(difference[axis], jacobian.row(axis), 1.0 / square(deviation),
                    0.5 * square(difference[axis] / deviation));
    }
  }
}

void add_priors(const Estimate& estimate, const SurfaceFitOptions& options, Equations& equations) {
  for (int angle = 0; angle < kAngleCount; ++angle) {
    const double value = estimate.pose.angles[angle];
    const int parameter = kPoseParameterCount + angle;
    equations.add_single(parameter, value - relaxed_angles()[angle], options.angle_deviation);
    const double beyond =
        value - std::clamp(value, angle_limits().lower[angle], angle_limits().upper[angle]);
    if (beyond != 0.0) equations.add_single(parameter, beyond, kLimitDeviation);
  }
  const ShapePrior& prior = shape_prior();
  for (int i = 0; i < kShapeParameterCount; ++i) {
    equations.add_single(kHandParameterCount + i, estimate.shape[i] - prior.mean[i],
                         options.shape_deviation * prior.deviation[i]);
  }
}

/// One stage of the fit: which terms count.
struct Stage {
  double keypoint_deviation;
  bool has_surface;
  int most_iterations;
};

class Fitter {
 public:
  Fitter(const ShapedHand& hand, const SurfaceFitTarget& target, const SurfaceFitOptions& options)
      : hand_(&hand), target_(&target), options_(&options) {
    samples_ = evenly_sampled(hand.model(HandShape()).rest_surface);
  }

  void minimise(const Stage& stage, Estimate& estimate, SurfaceFit& report) const {
    Equations current = linearise(stage, estimate);
    double damping = 1e-3;
    report.termination = Termination::iteration_limit;
    for (int i = 0; i < stage.most_iterations; ++i) {
      ++report.iterations;
      const Estimate trial = advanced_by(estimate, step(current, damping));
      const Equations ahead = linearise(stage, trial);
      const double gain = current.cost - ahead.cost;
      if (gain > 0.0) {
        const bool is_settled = gain < kEnergyTolerance * current.cost;
        estimate = trial;
        current = ahead;
        damping = std::max(0.3 * damping, 1e-7);
        if (is_settled) {
          report.termination = Termination::converged;
          return;
        }
      } else {
        damping *= 8.0;
        if (damping > kMostDamping) {
          report.termination = Termination::no_progress;
          return;
        }
      }
    }
  }

 private:
  Equations linearise(const Stage& stage, const Estimate& estimate) const {
    const TrialHand trial(*hand_, estimate);
    Equations equations;
    add_priors(estimate, *options_, equations);
    add_keypoints(trial, *target_, stage.keypoint_deviation, equations);
    if (stage.has_surface) add_surface_terms(trial, *target_, samples_, *options_, equations);
    return equations;
  }

  static Vector step(const Equations& equations, double damping) {
    Matrix damped = equations.hessian.selfadjointView<Eigen::Lower>();
    damped.diagonal() *= 1.0 + damping;
    Vector step = -damped.ldlt().solve(equations.gradient);
    const double turn =
        std::max(step.head<3>().norm(),
                 step.segment<kAngleCount>(kPoseParameterCount).cwiseAbs().maxCoeff());
    if (turn > kTurn) step *= kTurn / turn;
    return step;
  }

  static Estimate advanced_by(const Estimate& estimate, const Vector& step) {
    const ShapePrior& prior = shape_prior();
    Estimate next;
    next.pose = advanced(estimate.pose, step.head<kHandParameterCount>());
    next.shape = (estimate.shape + step.tail<kShapeParameterCount>())
                     .cwiseMax(prior.lower)
                     .cwiseMin(prior.upper);
    return next;
  }

  const ShapedHand* hand_;
  const SurfaceFitTarget* target_;
  const SurfaceFitOptions* options_;
  std::vector<SurfacePoint> samples_;
};

/// The mean hand, relaxed, with its palm on the palm's keypoints.
Estimate start(const ShapedHand& hand, const SurfaceFitTarget& target) {
  constexpr std::array<std::size_t, 5> kPalm = {0, 5, 9, 13, 17};
  Estimate estimate;
  estimate.pose.angles = relaxed_angles();
  const Skeleton skeleton = hand.model(HandShape()).skeleton;
  Eigen::Matrix3Xd in_hand(3, kPalm.size()), in_world(3, kPalm.size());
  for (std::size_t i = 0; i < kPalm.size(); ++i) {
    in_hand.col(static_cast<Eigen::Index>(i)) = skeleton.keypoints[kPalm[i]];
    in_world.col(static_cast<Eigen::Index>(i)) = target.keypoints()[kPalm[i]];
  }
  estimate.pose.world_from_hand = align_points(in_hand, in_world);
  return estimate;
}

}  // namespace

SurfaceFit fit_surface(const ShapedHand& hand, const HandSurface& given,
                       const SurfaceFitOptions& options) {
  const SurfaceFitTarget target(given);
  const Fitter fitter(hand, target, options);
  SurfaceFit fit;
  Estimate estimate = start(hand, target);
  fitter.minimise({0.005, false, kKeypointIterations}, estimate, fit);
  fitter.minimise({options.keypoint_deviation, true, options.most_iterations}, estimate, fit);
  fit.shape = estimate.shape;
  fit.pose = estimate.pose;
  fit.model = hand.model(shape_from_parameters(estimate.shape));
  measure_fit(target, fit);
  return fit;
}

}  // namespace tegata
