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

class OutlineSum {
 public:
  OutlineSum(const PosedHand& posed, const ShapeMotion* shape, const FitView& view,
             const ContourTermOptions& options, double count, double scale,
             FrameEquations& equations)
      : posed_(posed),
        shape_(shape),
        camera_(view.camera),
        sigma_{options.sigma * scale, options.violation_sigma * scale},
        precision_(options.weight / (count * options.standard_deviation *
                                     options.standard_deviation * scale * scale)),
        equations_(equations) {}

  // `gap_px` is the residual, `direction` its gradient by the outline point's pixel, `distance_px`
  // what the kernel is asked about.
  void add(const OutlinePoint& point, double gap_px, const Eigen::Vector2d& direction,
           double distance_px, bool is_violation) {
    const double metres_per_px = metres_per_pixel(point);
    const LorentzianKernel kernel(sigma_[is_violation ? 1 : 0]);
    const double distance = distance_px * metres_per_px;
    const Eigen::RowVector3d along =
        metres_per_px * direction.transpose() * project_jacobian(camera_, point.point);
    equations_.add(gap_px * metres_per_px, outline_row(posed_, point, along),
                   precision_ * kernel.weight(distance), precision_ * kernel.cost(distance),
                   outline_shape_row(shape_, point, along));
  }
  // A point without a counterpart costs what one at sigma costs, so that nothing is won by losing
  // it.
  void add_unmatched() {
    equations_.cost += precision_ * LorentzianKernel(sigma_[0]).cost(sigma_[0]);
  }

 private:
  double metres_per_pixel(const OutlinePoint& point) const {
    return (camera_.camera_from_world * point.point).z() / camera_.fx;
  }

  const PosedHand& posed_;
  const ShapeMotion* shape_;
  const Camera& camera_;
  double sigma_[2];
  double precision_;
  FrameEquations& equations_;
};

// Outline points against the distance to the silhouette's border. Positive gap: hand pixels lie
// outside the outline.
void add_outline_to_silhouette(const std::vector<OutlinePoint>& outline, const FitView& view,
                               OutlineSum& sum) {
  for (const OutlinePoint& point : outline) {
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
      sum.add(point, gap, gradient, std::abs(gap), gap > 0.0F);
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
    sum.add(*point, gap, -contour_point.normal, difference.norm(), gap > 0.0);
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
  OutlineSum outline_sum(posed, shape, view, options, static_cast<double>(outline.size()),
                         hand.scale, equations);
  add_outline_to_silhouette(outline, view, outline_sum);
  OutlineSum contour_sum(posed, shape, view, options,
                         static_cast<double>((view.contour.size() + step - 1) / step), hand.scale,
                         equations);
  add_silhouette_to_outline(outline, view, step, contour_sum);
}

}  // namespace tegata
