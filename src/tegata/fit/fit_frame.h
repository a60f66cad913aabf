// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tegata/fit/hull_term.h"
#include "tegata/fit/landmark_term.h"
#include "tegata/fit/view.h"

namespace tegata {

/// What is known of one moment. A frame may lack the hull (then only contours count).
struct FitFrame {
  std::vector<FitView> views;
  std::optional<HullTarget> hull;
  std::optional<StartLandmarks> landmarks;
};

}  // namespace tegata
