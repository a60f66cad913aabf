// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace tegata {

/// What parameters cost that are off what is known of them, with what a Newton step needs: the
/// precision is that of least squares with the same gradient, and never below 0.
struct PriorCost {
  Eigen::VectorXd precision, gradient;
  double cost = 0.0;
};

/// Of independent normal deviations.
PriorCost normal_prior(const Eigen::VectorXd& off, const Eigen::VectorXd& deviation);

/// Of a sample that may belong to another population: near the mean as normal_prior(), but with
/// m^2 the sum of all squared deviations, each in its standard deviation, the cost is
/// tail / 2 log(1 + m^2 / tail). What is far off as a whole is let go as a whole, in whatever way
/// it is off, as if all standard deviations were sqrt(1 + m^2 / tail) times as wide.
PriorCost heavy_tailed_prior(const Eigen::VectorXd& off, const Eigen::VectorXd& deviation,
                             double tail);

}  // namespace tegata
