// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "tegata/fit/solver.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/pipeline/silhouettes.h"
#include "tegata/take/take.h"

namespace tegata {

/// A frame on its way from pictures to the fit.
struct PreparedFrame {
  std::string name;
  double time = 0.0;                            ///< [s]
  std::string refusal;                          ///< why it cannot be fitted; empty where it can
  std::vector<std::string> notes;               ///< what a user should know of it
  FitFrame frame;                               ///< of the views in which the hand was seen
  std::map<std::string, std::string> left_out;  ///< why, by camera of the others
  TriangleMesh hull;                            ///< simplified
  double segment_seconds = 0.0, hull_seconds = 0.0;
};

/// Makes of a frame's pictures what the fit needs: the views' outlines and the visual hull. What is
/// wrong with one frame becomes its refusal, not an error.
PreparedFrame prepare_frame(const Segmenter& segmenter, const TakeFrame& pictures,
                            const HullOptions& options);

/// The same without the hull, which costs the more,
PreparedFrame prepare_views(const Segmenter& segmenter, const TakeFrame& pictures);
/// and the hull, where it is needed after all. Where a view of four or more leaves nothing of it,
/// that is left out; where there is none even so, that is the frame's refusal.
void add_hull(PreparedFrame& prepared, const HullOptions& options);

}  // namespace tegata
