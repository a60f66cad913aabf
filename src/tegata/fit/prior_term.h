// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "tegata/fit/normal_equations.h"
#include "tegata/hand/skeleton.h"

namespace tegata {

/// What is known of the angles before any picture. Standard deviations in radians.
struct PriorTermOptions {
  double limit_standard_deviation = 0.02;     ///< beyond a joint limit
  double flexion_standard_deviation = 0.8;    ///< about the relaxed hand
  double abduction_standard_deviation = 0.2;  ///< about the relaxed hand
  double coupling_standard_deviation = 0.3;   ///< of a DIP joint about two thirds of its PIP joint
  double weight = 1.0;                        ///< of the whole term
  /// What is known of the angles from other frames, where anything is.
  std::optional<JointAngles> previous;
  JointAngles previous_standard_deviations = JointAngles::Constant(0.15);
};

/// The relaxed hand, the coupling of the two last joints of a finger (the rule of two thirds;
/// Rijpkema and Girard 1991), the previous frame and joint limits (one-sided), as quadratic terms
/// of the angles. No number of pictures makes a joint bend beyond its limit, so that these count
/// once a frame.
void add_prior_term(const JointAngles& angles, const PriorTermOptions& options,
                    std::size_t frame_count, FrameEquations& equations);

}  // namespace tegata
