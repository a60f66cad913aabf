// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/proportion_prior.h"

#include <cmath>

namespace tegata {

PriorCost normal_prior(const Eigen::VectorXd& off, const Eigen::VectorXd& deviation) {
  PriorCost prior;
  prior.precision = deviation.cwiseAbs2().cwiseInverse();
  prior.gradient = prior.precision.cwiseProduct(off);
  prior.cost = 0.5 * off.dot(prior.gradient);
  return prior;
}

PriorCost heavy_tailed_prior(const Eigen::VectorXd& off, const Eigen::VectorXd& deviation,
                             double tail) {
  PriorCost prior = normal_prior(off, deviation);
  const double length_squared = 2.0 * prior.cost;
  const double weight = 1.0 / (1.0 + length_squared / tail);
  prior.precision *= weight;
  prior.gradient *= weight;
  prior.cost = 0.5 * tail * std::log1p(length_squared / tail);
  return prior;
}

}  // namespace tegata
