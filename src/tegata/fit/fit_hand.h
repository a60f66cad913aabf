// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tegata/fit/penetration_term.h"
#include "tegata/hand/hand_model.h"
#include "tegata/hand/skin_rows.h"
#include "tegata/image/rasterizer.h"

namespace tegata {

/// An edge of the hand's surface, each pair of neighbouring vertices once.
struct SurfaceEdge {
  std::uint32_t a = 0, b = 0;
};

/// A hand model with what the fit needs to know of it once. Keeps a reference to the model, which
/// must outlive it.
struct FitHand {
  explicit FitHand(const HandModel& hand);
  PosedHand posed(const HandPose& pose) const { return {*model, pose, rows}; }
  /// The same with a model of another shape that has the same triangles; `scale` and `samples`
  /// stay.
  FitHand with_model(const HandModel& hand) const;

  const HandModel* model;
  std::shared_ptr<const SkinRows> rows;
  /// Size relative to a hand whose wrist and middle fingertip are 0.18 m apart: every length of the
  /// options is multiplied by it, so that a scene in another unit has the same answer.
  double scale = 1.0;
  std::vector<SurfaceEdge> edges;
  /// For silhouettes: the whole surface, and without the triangles that lie on the forearm.
  EdgedTriangles drawn, drawn_beyond_wrist;
  /// One a vertex: 1 on the finger side of the wrist, 0 on the forearm, which bends on its own and
  /// says nothing of the hand's pose.
  std::vector<std::uint8_t> beyond_wrist;
  /// Vertices beyond the wrist all over the surface, a few hundred: the hull asks no more.
  std::vector<std::uint32_t> samples;
  DigitCapsules capsules;
};

}  // namespace tegata
