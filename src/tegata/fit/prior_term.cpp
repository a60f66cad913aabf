// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/prior_term.h"

#include <string_view>

namespace tegata {
namespace {

constexpr double kDipOverPip = 2.0 / 3.0;

bool is_abduction(int angle) {
  return angle_names()[static_cast<std::size_t>(angle)].ends_with("abduction");
}

void add_quadratic(double residual, const ParameterRow& jacobian, double standard_deviation,
                   double weight, FrameEquations& equations) {
  const double precision = weight / (standard_deviation * standard_deviation);
  equations.add(residual, jacobian, precision, 0.5 * precision * residual * residual);
}

ParameterRow unit_row(int angle) {
  ParameterRow row = ParameterRow::Zero();
  row[kPoseParameterCount + angle] = 1.0;
  return row;
}

}  // namespace

void add_prior_term(const JointAngles& angles, const PriorTermOptions& options,
                    std::size_t frame_count, FrameEquations& equations) {
  const AngleLimits& limits = angle_limits();
  for (int k = 0; k < kAngleCount; ++k) {
    const ParameterRow row = unit_row(k);
    const double beyond = angles[k] > limits.upper[k]   ? angles[k] - limits.upper[k]
                          : angles[k] < limits.lower[k] ? angles[k] - limits.lower[k]
                                                        : 0.0;
    if (beyond != 0.0) {
      add_quadratic(beyond, row, options.limit_standard_deviation,
                    options.weight * static_cast<double>(frame_count), equations);
    }
    add_quadratic(
        angles[k] - relaxed_angles()[k], row,
        is_abduction(k) ? options.abduction_standard_deviation : options.flexion_standard_deviation,
        options.weight, equations);
    if (options.previous) {
      add_quadratic(angles[k] - (*options.previous)[k], row,
                    options.previous_standard_deviations[k], options.weight, equations);
    }
  }
  for (int digit = 1; digit < kDigitCount; ++digit) {
    const int pip = kAnglesPerDigit * digit + 2, dip = pip + 1;
    ParameterRow row = unit_row(dip);
    row[kPoseParameterCount + pip] = -kDipOverPip;
    add_quadratic(angles[dip] - kDipOverPip * angles[pip], row, options.coupling_standard_deviation,
                  options.weight, equations);
  }
}

}  // namespace tegata
