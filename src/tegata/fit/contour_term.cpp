// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/contour_term.h"

#include <cmath>
#include <limits>

#include "tegata/fit/outline.h"
#include "tegata/fit/outline_sum.h"
#include "tegata/image/distance_transform.h"

namespace tegata {
namespace {

// Two distances agree on which border is the nearest one.
constexpr float kSameBorderPx = 0.25F;
// An outline point and a contour point belong together if they face the same way within 60 degrees.
constexpr double kLeastNormalProduct = 0.5;

// How far beside a border what hides the hand is looked for.
constexpr double kBesidePx = 3.0;

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
    if (gap < 0.0F && is_hidden_there(view, point.point, point.pixel)) continue;
    if (std::abs(gap - sample_bilinear(*view.possible_distance, x, y)) > kSameBorderPx) continue;
    const Eigen::Vector2d gradient = distance_gradient(view, point.pixel);
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
  visit_from(outline, contour_point.pixel.x(), consider);
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
    if (is_hidden_there(view, point->point, beside)) continue;
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
  OutlineSum sum(
      metres_per_px(outline, view.camera),
      {options.sigma, options.violation_sigma, options.standard_deviation, options.weight},
      hand.scale);
  add_outline_to_silhouette(outline, view, sum);
  add_silhouette_to_outline(outline, view, step, sum);
  equations.cost += sum.cost();
  sum.for_each_row(
      [&](std::size_t i, const Eigen::RowVector2d& metres_along, double weight, double gap) {
        const OutlinePoint& point = outline[i];
        const Eigen::RowVector3d along = metres_along * project_jacobian(view.camera, point.point);
        equations.add(gap, outline_row(posed, point, along), weight, 0.0,
                      outline_shape_row(shape, point, along));
      });
}

}  // namespace tegata
