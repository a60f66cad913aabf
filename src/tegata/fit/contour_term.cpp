// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/contour_term.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "tegata/fit/outline.h"
#include "tegata/image/distance_transform.h"
#include "tegata/math/robust_kernel.h"

namespace tegata {
namespace {

// Two distances agree on which border is the nearest one.
constexpr float kSameBorderPx = 0.25F;
// An outline point and a contour point belong together if they face the same way within 60 degrees.
constexpr double kLeastNormalProduct = 0.5;

// How far beside a border what hides the hand is looked for.
constexpr double kBesidePx = 3.0;

bool is_hidden(const OutlinePoint& point, const Eigen::Vector2d& pixel, const FitView& view) {
  return view.hiding_depth &&
         view.is_hidden(pixel, (view.camera.camera_from_world * point.point).z());
}

// What is asked of the outline's points, summed up for each: the normal equations of all residuals
// at a point are those of its pixel, two rows, whatever their directions.
class OutlineSum {
 public:
  OutlineSum(const std::vector<OutlinePoint>& outline, const FitView& view,
             const ContourTermOptions& options, double scale)
      : outline_(outline),
        camera_(view.camera),
        kernels_{LorentzianKernel(options.sigma * scale),
                 LorentzianKernel(options.violation_sigma * scale)},
        precision_(options.weight /
                   (options.standard_deviation * options.standard_deviation * scale * scale)),
        unmatched_cost_(kernels_[0].cost(options.sigma * scale)),
        pixels_(outline.size()) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const double depth = (camera_.camera_from_world * outline[i].point).z();
      pixels_[i].metres_per_px = depth / camera_.fx;
    }
  }

  // The residuals that follow are `count`: their mean counts.
  void begin(double count) { share_ = precision_ / count; }
  // `gap_px` is the residual, `direction` its gradient by the outline point's pixel, `distance_px`
  // what the kernel is asked about.
  void add(std::size_t point, double gap_px, const Eigen::Vector2d& direction, double distance_px,
           bool is_violation) {
    PixelSum& pixel = pixels_[point];
    const LorentzianKernel& kernel = kernels_[is_violation ? 1 : 0];
    const double distance = distance_px * pixel.metres_per_px;
    const Eigen::Vector2d weighted = share_ * kernel.weight(distance) * direction;
    pixel.information += weighted * direction.transpose();
    pixel.gradient += gap_px * weighted;
    cost_ += share_ * kernel.cost(distance);
  }
  // A point without a counterpart costs what one at sigma costs, so that nothing is won by losing
  // it.
  void add_unmatched() { cost_ += share_ * unmatched_cost_; }

  void add_to(FrameEquations& equations, const PosedHand& posed, const ShapeMotion* shape) const {
    equations.cost += cost_;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const PixelSum& pixel = pixels_[i];
      // L D L^T of the 2 x 2 sum, the larger entry first.
      const int first = pixel.information(1, 1) > pixel.information(0, 0) ? 1 : 0;
      const double larger = pixel.information(first, first);
      if (!(larger > 0.0)) continue;
      const double factor = pixel.information(0, 1) / larger;
      const double smaller = pixel.information(1 - first, 1 - first) - factor * factor * larger;
      const double rest = pixel.gradient[1 - first] - factor * pixel.gradient[first];
      Eigen::Vector2d direction = Eigen::Vector2d::Unit(1 - first);
      if (smaller > 1e-12 * larger) {
        add_row(i, direction, smaller, rest / smaller, equations, posed, shape);
      }
      direction *= factor;
      direction[first] = 1.0;
      add_row(i, direction, larger, pixel.gradient[first] / larger, equations, posed, shape);
    }
  }

 private:
  struct PixelSum {
    double metres_per_px = 0.0;
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  // sum of w d d^T
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();     // sum of w gap d
  };

  // A residual in pixels along a direction of the picture.
  void add_row(std::size_t i, const Eigen::Vector2d& direction, double weight, double gap_px,
               FrameEquations& equations, const PosedHand& posed, const ShapeMotion* shape) const {
    const OutlinePoint& point = outline_[i];
    const double metres_per_px = pixels_[i].metres_per_px;
    const Eigen::RowVector3d along =
        metres_per_px * direction.transpose() * project_jacobian(camera_, point.point);
    equations.add(gap_px * metres_per_px, outline_row(posed, point, along), weight, 0.0,
                  outline_shape_row(shape, point, along));
  }

  const std::vector<OutlinePoint>& outline_;
  const Camera& camera_;
  LorentzianKernel kernels_[2];
  double precision_, unmatched_cost_, share_ = 0.0, cost_ = 0.0;
  std::vector<PixelSum> pixels_;
};

// Outline points against the distance to the silhouette's border. Positive gap: hand pixels lie
// outside the outline.
void add_outline_to_silhouette(const std::vector<OutlinePoint>& outline, const FitView& view,
                               OutlineSum& sum) {
  sum.begin(static_cast<double>(outline.size()));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const OutlinePoint& point = outline[i];
    if (!point.beyond_wrist || view.is_forearm(point.pixel)) continue;
    const double x = point.pixel.x(), y = point.pixel.y();
    const float gap = sample_bilinear(*view.hand_distance, x, y);
    if (gap < 0.0F && is_hidden(point, point.pixel, view)) continue;
    if (std::abs(gap - sample_bilinear(*view.possible_distance, x, y)) > kSameBorderPx) continue;
    const Eigen::Vector2d gradient(0.5 * (sample_bilinear(*view.hand_distance, x + 1.0, y) -
                                          sample_bilinear(*view.hand_distance, x - 1.0, y)),
                                   0.5 * (sample_bilinear(*view.hand_distance, x, y + 1.0) -
                                          sample_bilinear(*view.hand_distance, x, y - 1.0)));
    // The distance falls outwards; a border that faces another way is another finger's.
    if (-gradient.dot(point.normal) < kLeastNormalProduct) {
      sum.add_unmatched();
    } else {
      sum.add(i, gap, gradient, std::abs(gap), gap > 0.0F);
    }
  }
}

// The outline is sorted by x: the search goes from the contour point's x to either side.
const OutlinePoint* nearest_facing(const std::vector<OutlinePoint>& outline,
                                   const ContourPoint& contour_point) {
  const OutlinePoint* best = nullptr;
  double best_squared = std::numeric_limits<double>::infinity();
  // False where this point and those beyond it are farther away than the best one.
  const auto consider = [&](const OutlinePoint& point) {
    const Eigen::Vector2d difference = point.pixel - contour_point.pixel;
    if (difference.x() * difference.x() > best_squared) return false;
    const double squared = difference.squaredNorm();
    if (squared < best_squared && point.normal.dot(contour_point.normal) > kLeastNormalProduct) {
      best_squared = squared;
      best = &point;
    }
    return true;
  };
  const auto middle =
      std::lower_bound(outline.begin(), outline.end(), contour_point.pixel.x(),
                       [](const OutlinePoint& point, double x) { return point.pixel.x() < x; });
  auto right = middle;
  auto left = std::make_reverse_iterator(middle);
  bool goes_right = true, goes_left = true;
  while (goes_right || goes_left) {
    goes_right = goes_right && right != outline.end() && consider(*right++);
    goes_left = goes_left && left != outline.rend() && consider(*left++);
  }
  return best;
}

// Contour points of the silhouette against the nearest outline point that faces the same way.
void add_silhouette_to_outline(const std::vector<OutlinePoint>& outline, const FitView& view,
                               std::size_t step, OutlineSum& sum) {
  sum.begin(static_cast<double>((view.contour.size() + step - 1) / step));
  for (std::size_t i = 0; i < view.contour.size(); i += step) {
    const ContourPoint& contour_point = view.contour[i];
    if (view.is_forearm(contour_point.pixel)) continue;
    const OutlinePoint* point = nearest_facing(outline, contour_point);
    if (point == nullptr || !point->beyond_wrist) {
      sum.add_unmatched();
      continue;
    }
    // Where the hand goes on behind something, its border is that one's.
    const Eigen::Vector2d beside = contour_point.pixel + kBesidePx * contour_point.normal;
    if (is_hidden(*point, beside, view)) continue;
    const Eigen::Vector2d difference = point->pixel - contour_point.pixel;
    const double gap = -contour_point.normal.dot(difference);
    sum.add(static_cast<std::size_t>(point - outline.data()), gap, -contour_point.normal,
            difference.norm(), gap > 0.0);
  }
}

}  // namespace

void add_contour_term(const FitHand& hand, const PosedHand& posed, const FitView& view,
                      const ContourTermOptions& options, FrameEquations& equations,
                      const ShapeMotion* shape) {
  const auto step = static_cast<std::size_t>(options.coarseness);
  const std::vector<OutlinePoint> outline =
      hand_outline(hand, posed, view.camera, options.coarseness);
  if (outline.empty() || view.contour.empty()) return;
  OutlineSum sum(outline, view, options, hand.scale);
  add_outline_to_silhouette(outline, view, sum);
  add_silhouette_to_outline(outline, view, step, sum);
  sum.add_to(equations, posed, shape);
}

}  // namespace tegata
