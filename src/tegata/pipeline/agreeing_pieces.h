// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// How far the silhouettes of one moment contradict each other: the mean over the pairs of cameras
/// of the angle by which their tangent planes differ (calibrate/tangency.h) [rad]; 0 where no pair
/// has any. The silhouettes are those of the cameras as they are, with their distortion.
double disagreement(const CameraRig& rig, const std::vector<std::optional<Silhouette>>& views);

/// The largest pieces of a silhouette, each alone; none where it has but one.
std::vector<Silhouette> pieces_alone(const Silhouette& silhouette);

/// The picture without what the silhouette shows: rows are filled from beside it.
CameraImage without_hand(const CameraImage& picture, const Silhouette& silhouette);

/// What could be the hand in each camera's picture, the likeliest first; none without a picture.
using HandCandidates = std::vector<std::vector<Silhouette>>;

/// Which candidate of each camera, by its index, makes the views agree best: a face in one picture,
/// or a kettle that is warmer and larger than the hand, does not stand where the other pictures
/// have the hand. The first of each camera unless others agree far better.
std::vector<std::size_t> agreeing_candidates(const CameraRig& rig,
                                             const HandCandidates& candidates);

}  // namespace tegata
