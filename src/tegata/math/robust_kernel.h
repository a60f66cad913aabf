// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace tegata {

/// The Lorentzian M-estimator of the paper (IV-A, after Wheeler and Ikeuchi 1995). It takes
/// distances, never squared ones; sigma and the distance share a unit.
class LorentzianKernel {
 public:
  explicit LorentzianKernel(double sigma) : inverse_sigma_(1.0 / sigma) {}

  /// rho(z) = sigma^2 log(1 + (z / sigma)^2 / 2), which is z^2 / 2 for small z.
  double cost(double distance) const {
    const double z = distance * inverse_sigma_;
    return std::log1p(0.5 * z * z) / (inverse_sigma_ * inverse_sigma_);
  }
  /// rho'(z) / z = 1 / (1 + (z / sigma)^2 / 2): 1 at zero, falling to 0.
  double weight(double distance) const {
    const double z = distance * inverse_sigma_;
    return 1.0 / (1.0 + 0.5 * z * z);
  }

 private:
  double inverse_sigma_;
};

}  // namespace tegata
