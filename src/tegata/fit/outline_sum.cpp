// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/outline_sum.h"

#include <utility>

#include "tegata/image/distance_transform.h"

namespace tegata {

OutlineSum::OutlineSum(std::vector<double> metres_per_px, const OutlineWeights& weights,
                       double scale)
    : metres_per_px_(std::move(metres_per_px)),
      kernels_{LorentzianKernel(weights.sigma * scale),
               LorentzianKernel(weights.violation_sigma * scale)},
      precision_(weights.weight /
                 (weights.standard_deviation * weights.standard_deviation * scale * scale)),
      unmatched_cost_(kernels_[0].cost(weights.sigma * scale)),
      pixels_(metres_per_px_.size()) {}

void OutlineSum::add(std::size_t point, double gap_px, const Eigen::Vector2d& direction,
                     double distance_px, bool is_violation, double weight) {
  PixelSum& pixel = pixels_[point];
  const LorentzianKernel& kernel = kernels_[is_violation ? 1 : 0];
  const double distance = distance_px * metres_per_px_[point];
  const Eigen::Vector2d weighted = weight * share_ * kernel.weight(distance) * direction;
  pixel.information += weighted * direction.transpose();
  pixel.gradient += gap_px * weighted;
  cost_ += weight * share_ * kernel.cost(distance);
}

Eigen::Vector2d distance_gradient(const FitView& view, const Eigen::Vector2d& pixel) {
  const double x = pixel.x(), y = pixel.y();
  const Image<float>& distance = *view.hand_distance;
  return {0.5 * (sample_bilinear(distance, x + 1.0, y) - sample_bilinear(distance, x - 1.0, y)),
          0.5 * (sample_bilinear(distance, x, y + 1.0) - sample_bilinear(distance, x, y - 1.0))};
}

bool is_hidden_there(const FitView& view, const Eigen::Vector3d& point,
                     const Eigen::Vector2d& pixel) {
  return view.hiding_depth && view.is_hidden(pixel, (view.camera.camera_from_world * point).z());
}

}  // namespace tegata
