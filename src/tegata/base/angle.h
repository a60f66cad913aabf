// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace tegata {

/// Angles are in radians everywhere but where people read them.
inline constexpr double kDegree = std::numbers::pi / 180.0;            ///< [rad]
inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;  ///< [deg/rad]

}  // namespace tegata
