// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>

namespace tegata {

/// The Jacobian (m x n) of a function from n to m numbers at x by central differences. Every
/// analytic Jacobian of the project is checked against this one.
Eigen::MatrixXd finite_difference_jacobian(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& function,
    const Eigen::VectorXd& x, double step = 1e-6);

}  // namespace tegata
