// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/finite_difference.h"

namespace tegata {

Eigen::MatrixXd finite_difference_jacobian(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& function,
    const Eigen::VectorXd& x, double step) {
  Eigen::MatrixXd jacobian(function(x).size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd ahead = x, behind = x;
    ahead[i] += step;
    behind[i] -= step;
    jacobian.col(i) = (function(ahead) - function(behind)) / (ahead[i] - behind[i]);
  }
  return jacobian;
}

}  // namespace tegata
