// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "tegata/fit/view.h"
#include "tegata/math/robust_kernel.h"

namespace tegata {

/// How the outline in a picture is weighed: kernels' sigmas and the deviation of a seen outline [m]
/// of a hand of FitHand::scale 1, and the weight of the whole.
struct OutlineWeights {
  double sigma, violation_sigma, standard_deviation, weight;
};

/// What is asked of points of the outline in a picture, summed up for each: the normal equations of
/// all residuals at a point are those of its pixel, two rows, whatever their directions.
class OutlineSum {
 public:
  /// `metres_per_px` at the depth of each point; `scale` of the hand.
  OutlineSum(std::vector<double> metres_per_px, const OutlineWeights& weights, double scale);

  /// The residuals that follow have so much weight in all: their mean counts.
  void begin(double weight) { share_ = precision_ / weight; }
  /// `gap_px` is the residual, `direction` its gradient by the point's pixel, `distance_px` what
  /// the kernel is asked about.
  void add(std::size_t point, double gap_px, const Eigen::Vector2d& direction, double distance_px,
           bool is_violation, double weight = 1.0);
  /// A point without a counterpart costs what one at sigma costs, so that nothing is won by losing
  /// it.
  void add_unmatched(double weight = 1.0) { cost_ += weight * share_ * unmatched_cost_; }

  double cost() const { return cost_; }
  /// Calls add(point, metres_along, weight, gap) for each row: by how many metres the residual
  /// grows for a pixel's shift along x and y, and the residual [m].
  template <typename AddRow>
  void for_each_row(const AddRow& add) const;

 private:
  struct PixelSum {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  // sum of w d d^T
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();     // sum of w gap d
  };

  std::vector<double> metres_per_px_;
  LorentzianKernel kernels_[2];
  double precision_, unmatched_cost_, share_ = 0.0, cost_ = 0.0;
  std::vector<PixelSum> pixels_;
};

/// Of a pixel at the depth of each point.
template <typename Point>
std::vector<double> metres_per_px(const std::vector<Point>& points, const Camera& camera) {
  std::vector<double> metres;
  for (const Point& point : points) {
    metres.push_back((camera.camera_from_world * point.point).z() / camera.fx);
  }
  return metres;
}

/// In which direction, and how fast, the distance to the silhouette's border grows in a pixel.
Eigen::Vector2d distance_gradient(const FitView& view, const Eigen::Vector2d& pixel);

/// Whether something that hides the hand stands before one of its points in a pixel.
bool is_hidden_there(const FitView& view, const Eigen::Vector3d& point,
                     const Eigen::Vector2d& pixel);

/// Visits points that are sorted by their pixels' x from one x to either side, each side for as
/// long as visit(point) is true.
template <typename Point, typename Visit>
void visit_from(const std::vector<Point>& points, double x, const Visit& visit) {
  const auto middle =
      std::lower_bound(points.begin(), points.end(), x,
                       [](const Point& point, double at) { return point.pixel.x() < at; });
  auto right = middle;
  auto left = std::make_reverse_iterator(middle);
  bool goes_right = true, goes_left = true;
  while (goes_right || goes_left) {
    goes_right = goes_right && right != points.end() && visit(*right++);
    goes_left = goes_left && left != points.rend() && visit(*left++);
  }
}

template <typename AddRow>
void OutlineSum::for_each_row(const AddRow& add) const {
  const auto add_along = [&](std::size_t i, const Eigen::Vector2d& direction, double weight,
                             double gap_px) {
    const Eigen::RowVector2d along = metres_per_px_[i] * direction.transpose();
    add(i, along, weight, gap_px * metres_per_px_[i]);
  };
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const PixelSum& pixel = pixels_[i];
    // L D L^T of the 2 x 2 sum, the larger entry first.
    const int first = pixel.information(1, 1) > pixel.information(0, 0) ? 1 : 0;
    const double larger = pixel.information(first, first);
    if (!(larger > 0.0)) continue;
    const double factor = pixel.information(0, 1) / larger;
    const double smaller = pixel.information(1 - first, 1 - first) - factor * factor * larger;
    const double rest = pixel.gradient[1 - first] - factor * pixel.gradient[first];
    Eigen::Vector2d direction = Eigen::Vector2d::Unit(1 - first);
    if (smaller > 1e-12 * larger) add_along(i, direction, smaller, rest / smaller);
    direction *= factor;
    direction[first] = 1.0;
    add_along(i, direction, larger, pixel.gradient[first] / larger);
  }
}

}  // namespace tegata
