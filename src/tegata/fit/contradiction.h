// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tegata/fit/frame_fit.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// uncovered_distance() in each view of a frame [m]; 0 where a view can say nothing.
std::vector<double> uncovered_distances(const FitHand& hand, const FitFrame& frame,
                                        const HandPose& pose);

/// A view that contradicts the others of its frame: a camera that was pushed, or a picture of
/// another moment.
struct Contradiction {
  std::size_t frame = 0, view = 0;  ///< positions
  HandPose pose;                    ///< of the hand by the other views
};

struct ContradictionOptions {
  FitSchedule schedule = object_schedule();  ///< for a pose by other views, the angles held
  HullOptions hull;                          ///< of the views that are left
};

/// Looks for views that see much of a hand beside where the others of the frame have it, while they
/// agree on it once they are alone (uncovered_distance()), and draw it away from there again; one a
/// frame at most. What hides the hand
/// contradicts nothing: it takes from what is seen and adds nothing. Usual is what half of all
/// views exceed, so that a hand of another shape than the fitted one contradicts nothing either.
/// Frames of fewer than three views are passed over.
/// @param poses where the frames' fits have the hand, with all views
/// @param object what hides it, in its frame; may be empty
std::vector<Contradiction> find_contradictions(const FitHand& hand,
                                               std::span<const FitFrame* const> frames,
                                               const std::vector<HandPose>& poses,
                                               const TriangleMesh& object,
                                               const ContradictionOptions& options, int threads);

/// Frames without the views that contradict the others of their frame. Keeps pointers to the given
/// frames.
class AgreeingFrames {
 public:
  explicit AgreeingFrames(std::span<const FitFrame* const> frames);

  const std::vector<const FitFrame*>& frames() const { return frames_; }
  /// Names of the cameras that were left out, for each frame.
  const std::vector<std::vector<std::string>>& left_out() const { return left_out_; }

  /// Leaves out what find_contradictions() finds; those frames have their hulls from the views that
  /// are left, none where these have none, and their poses by these. True where there were any.
  bool leave_out_contradictions(const FitHand& hand, std::vector<HandPose>& poses,
                                const TriangleMesh& object, const ContradictionOptions& options,
                                int threads);

 private:
  std::vector<const FitFrame*> frames_;
  std::vector<std::unique_ptr<const FitFrame>> mended_;
  std::vector<std::vector<std::string>> left_out_;
};

}  // namespace tegata
