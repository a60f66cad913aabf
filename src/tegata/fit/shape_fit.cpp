// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/shape_fit.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/fit/proportion_prior.h"
#include "tegata/fit/shape_system.h"
#include "tegata/fit/surroundings.h"
#include "tegata/hand/scaled_hand.h"

namespace tegata {
namespace {

// Residuals are not independent of each other, from point to point and from frame to frame: the
// pictures' precision is divided by the square of this before it meets the prior's.
constexpr double kDeviationScale = 4.0;
// Of all proportions together (heavy_tailed_prior()): hands of children, of games and of animation
// are not of adults' proportions, and what holds an adult's regular would bend theirs.
constexpr double kProportionTail = 10.0;
// Largest change of the shape that is none, in the prior's deviations.
constexpr double kShapeTolerance = 2e-3;

/// What is known of shape parameters before any picture.
struct Prior {
  Eigen::VectorXd mean, deviation, lower, upper;
  PriorCost (*cost)(const Eigen::VectorXd& off, const Eigen::VectorXd& deviation) = normal_prior;
};

PriorCost proportion_cost(const Eigen::VectorXd& off, const Eigen::VectorXd& deviation) {
  return heavy_tailed_prior(off, deviation, kProportionTail);
}

/// The hand at a value of the shape that is sought.
class TrialHand {
 public:
  virtual ~TrialHand() = default;
  const HandModel& model() const { return model_; }
  virtual std::unique_ptr<ShapeMotion> motion(const PosedHand& posed) const = 0;

 protected:
  explicit TrialHand(HandModel model) : model_(std::move(model)) {}

 private:
  HandModel model_;
};

/// The shape that is sought: what it does to a hand, and its prior.
class SoughtShape {
 public:
  virtual ~SoughtShape() = default;
  virtual std::unique_ptr<TrialHand> at(const Eigen::VectorXd& shape) const = 0;
  const Prior& prior() const { return prior_; }

 protected:
  explicit SoughtShape(Prior prior) : prior_(std::move(prior)) {}

 private:
  Prior prior_;
};

class SoughtScale : public SoughtShape {
 public:
  SoughtScale(const HandModel& hand, double deviation)
      : SoughtShape({Eigen::VectorXd::Constant(1, 1.0), Eigen::VectorXd::Constant(1, deviation),
                     Eigen::VectorXd::Constant(1, 0.6), Eigen::VectorXd::Constant(1, 1.6),
                     normal_prior}),
        hand_(&hand) {}

  std::unique_ptr<TrialHand> at(const Eigen::VectorXd& shape) const override {
    return std::make_unique<Trial>(*hand_, shape[0]);
  }

 private:
  class Trial : public TrialHand {
   public:
    Trial(const HandModel& hand, double scale) : TrialHand(scaled(hand, scale)), scale_(scale) {}
    std::unique_ptr<ShapeMotion> motion(const PosedHand& posed) const override {
      return std::make_unique<ScaleMotion>(posed, scale_);
    }

   private:
    double scale_;
  };
  const HandModel* hand_;
};

class SoughtParameters : public SoughtShape {
 public:
  explicit SoughtParameters(const ShapedHand& hand)
      : SoughtShape({shape_prior().mean, shape_prior().deviation, shape_prior().lower,
                     shape_prior().upper, proportion_cost}),
        hand_(&hand) {}

  std::unique_ptr<TrialHand> at(const Eigen::VectorXd& shape) const override {
    return std::make_unique<Trial>(*hand_, shape);
  }

 private:
  class Trial : public TrialHand {
   public:
    Trial(const ShapedHand& hand, const ShapeParameters& parameters)
        : TrialHand(hand.model(shape_from_parameters(parameters))),
          basis_(hand.basis(parameters)) {}
    std::unique_ptr<ShapeMotion> motion(const PosedHand& posed) const override {
      return std::make_unique<ParameterMotion>(model(), basis_, posed.pose());
    }

   private:
    ShapeBasis basis_;
  };
  const ShapedHand* hand_;
};

struct Estimate {
  std::vector<HandEstimate> grasps;
  Eigen::VectorXd shape;
};

struct Linearisation {
  std::vector<GraspEquations> grasps;
  Eigen::VectorXd prior_precision, prior_gradient;
  double prior_cost = 0.0;

  double energy() const {
    double sum = prior_cost;
    for (const GraspEquations& grasp : grasps) {
      sum += grasp.prior.cost;
      for (const FrameEquations& frame : grasp.frames) sum += frame.cost;
    }
    return sum;
  }
  ShapeSystem system() const { return {grasps, prior_precision, prior_gradient}; }
};

/// What descend() asks for. The lengths of the options go with the prior's hand, so that nothing is
/// won by growing.
class Problem {
 public:
  Problem(const SoughtShape& sought, const FitHand& mean, std::span<const GraspFrames> grasps,
          const FitStage& stage, int threads)
      : sought_(&sought), mean_(&mean), grasps_(grasps), stage_(&stage), threads_(threads) {
    for (std::size_t g = 0; g < grasps.size(); ++g) {
      for (std::size_t f = 0; f < grasps[g].frames.size(); ++f) all_frames_.emplace_back(g, f);
    }
  }

  Linearisation linearise(const Estimate& estimate) const {
    const std::unique_ptr<TrialHand> trial = sought_->at(estimate.shape);
    const FitHand hand = mean_->with_model(trial->model());
    const FrameEquations nothing(static_cast<int>(estimate.shape.size()));
    Linearisation result;
    for (std::size_t g = 0; g < grasps_.size(); ++g) {
      GraspEquations& grasp = result.grasps.emplace_back();
      grasp.frames.assign(grasps_[g].frames.size(), nothing);
      add_angle_terms(hand, estimate.grasps[g].angles, *stage_, grasps_[g].frames.size(),
                      grasp.prior);
    }
    parallel_for(all_frames_.size(), threads_, [&](std::size_t i) {
      const auto [g, f] = all_frames_[i];
      const PosedHand posed = hand.posed(estimate.grasps[g].pose(f));
      const std::unique_ptr<ShapeMotion> motion = trial->motion(posed);
      add_frame_terms(hand, posed, *grasps_[g].frames[f], *stage_, result.grasps[g].frames[f],
                      motion.get());
    });
    add_shape_prior(estimate.shape, result);
    return result;
  }

  ShapeStep step(const Linearisation& at, double damping) const {
    ShapeStep step = at.system().solve(damping);
    double turn = 0.0;
    for (const ArrowStep& grasp : step.grasps) turn = std::max(turn, longest_turn(grasp));
    if (turn > kLongestTurn) {
      const double factor = kLongestTurn / turn;
      step.shape *= factor;
      for (ArrowStep& grasp : step.grasps) grasp = shortened(std::move(grasp), factor);
    }
    return step;
  }

  bool is_negligible(const ShapeStep& step) const {
    return (step.shape.cwiseAbs().array() <= kShapeTolerance * sought_->prior().deviation.array())
               .all() &&
           std::all_of(step.grasps.begin(), step.grasps.end(), [&](const ArrowStep& grasp) {
             return tegata::is_negligible(grasp, mean_->scale);
           });
  }

  Estimate advanced(const Estimate& estimate, const ShapeStep& step) const {
    Estimate next = estimate;
    for (std::size_t g = 0; g < next.grasps.size(); ++g) {
      next.grasps[g] = tegata::advanced(estimate.grasps[g], step.grasps[g]);
    }
    next.shape = (estimate.shape + step.shape)
                     .cwiseMax(sought_->prior().lower)
                     .cwiseMin(sought_->prior().upper);
    return next;
  }

 private:
  void add_shape_prior(const Eigen::VectorXd& shape, Linearisation& result) const {
    const Prior& prior = sought_->prior();
    const PriorCost cost = prior.cost(shape - prior.mean, prior.deviation);
    constexpr double kScale = kDeviationScale * kDeviationScale;
    result.prior_precision = kScale * cost.precision;
    result.prior_gradient = kScale * cost.gradient;
    result.prior_cost = kScale * cost.cost;
  }

  const SoughtShape* sought_;
  const FitHand* mean_;
  std::span<const GraspFrames> grasps_;
  const FitStage* stage_;
  int threads_;
  std::vector<std::pair<std::size_t, std::size_t>> all_frames_;
};

struct Found {
  Eigen::VectorXd shape, standard_deviations;
  double energy = 0.0;
  Descent descent;
};

// The frames of grasps with forearm and hidden objects drawn where the estimates have them.
struct SurroundedGrasps {
  SurroundedGrasps(const FitHand& hand, std::span<const GraspFrames> grasps,
                   const std::vector<HandEstimate>& estimates, int threads) {
    frames.reserve(grasps.size());
    for (std::size_t g = 0; g < grasps.size(); ++g) {
      frames.push_back(
          with_surroundings(hand, grasps[g].frames, estimates[g], grasps[g].object, threads));
      pointers.push_back({pointers_to(frames.back()), estimates[g], {}});
    }
  }

  std::vector<std::vector<FitFrame>> frames;
  std::vector<GraspFrames> pointers;
};

Found minimise_all(const SoughtShape& sought, const Eigen::VectorXd& start,
                   const FitSchedule& schedule, int threads, std::span<GraspFrames> grasps) {
  Estimate estimate;
  std::size_t frame_count = 0;
  for (const GraspFrames& grasp : grasps) {
    estimate.grasps.push_back(grasp.estimate);
    frame_count += grasp.frames.size();
  }
  if (frame_count == 0) throw Error("shape fit: got no frame, expected at least one");
  estimate.shape = start;
  const std::unique_ptr<TrialHand> mean = sought.at(sought.prior().mean);
  const FitHand hand(mean->model());
  Found found;
  for (const FitStage& stage : schedule.stages) {
    const std::unique_ptr<TrialHand> trial = sought.at(estimate.shape);
    const SurroundedGrasps surrounded(hand.with_model(trial->model()), grasps, estimate.grasps,
                                      threads);
    const Problem problem(sought, hand, surrounded.pointers, stage, threads);
    Linearisation current = problem.linearise(estimate);
    const Descent descent = descend(problem, stage.most_iterations, estimate, current);
    found.descent = {found.descent.iterations + descent.iterations, descent.termination};
    found.energy = current.energy();
    found.standard_deviations =
        kDeviationScale * current.system().covariance().diagonal().cwiseMax(0.0).cwiseSqrt();
  }
  for (std::size_t g = 0; g < grasps.size(); ++g) grasps[g].estimate = estimate.grasps[g];
  found.shape = estimate.shape;
  return found;
}

// One frame alone tells little of what hides the hand in it.
void find_objects(const FitHand& hand, const ShapeFitOptions& options,
                  std::span<GraspFrames> grasps) {
  for (GraspFrames& grasp : grasps) {
    if (grasp.frames.size() < 2) continue;
    const std::vector<FitFrame> frames =
        with_surroundings(hand, grasp.frames, grasp.estimate, {}, options.threads);
    grasp.object = find_hidden_object(hand, pointers_to(frames), grasp.estimate, options.object,
                                      options.threads)
                       .surface;
  }
}

}  // namespace

ScaleFit fit_scale(const HandModel& hand, double start, std::span<GraspFrames> grasps,
                   const ShapeFitOptions& options) {
  const SoughtScale sought(hand, options.scale_deviation);
  const Found found = minimise_all(sought, Eigen::VectorXd::Constant(1, start), options.scale,
                                   options.threads, grasps);
  return {found.shape[0], found.standard_deviations[0], found.energy, found.descent.iterations,
          found.descent.termination};
}

ShapeFit fit_shape(const ShapedHand& hand, const ShapeParameters& start,
                   std::span<GraspFrames> grasps, const ShapeFitOptions& options) {
  const SoughtParameters sought(hand);
  Found found = minimise_all(sought, start, options.shape, options.threads, grasps);
  for (int round = 1; round < options.shape_rounds; ++round) {
    const std::unique_ptr<TrialHand> trial = sought.at(found.shape);
    find_objects(FitHand(trial->model()), options, grasps);
    const int before = found.descent.iterations;
    found = minimise_all(sought, found.shape, options.shape, options.threads, grasps);
    found.descent.iterations += before;
  }
  return {found.shape, found.standard_deviations, found.descent.iterations,
          found.descent.termination};
}

}  // namespace tegata
