// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/camera/scene_frame.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/image/silhouette.h"
#include "tegata/image/undistortion.h"
#include "tegata/segment/segmentation_report.h"
#include "tegata/take/take.h"

namespace tegata {

/// The method that suits a take: what it says itself, or else by its pictures: masks where it has
/// them, background where it has pictures of the empty scene, infrared for pictures of one channel
/// or without colour, skin for colour.
SegmentationMethod choose_segmentation(Take& take, const Observer& observer);

/// Makes silhouettes of a take's pictures. What is one for all frames is made once.
class Segmenter {
 public:
  /// By the method that is asked for, or else by the one that suits the take; its cameras are those
  /// of the take in the world, or in the scene that is given. Throws Error where the method is
  /// `background` and a camera has no picture of the empty scene.
  Segmenter(Take& take, std::optional<SegmentationMethod> method, const Observer& observer,
            const std::optional<SceneFrame>& scene = {});

  SegmentationMethod method() const { return method_; }
  const CameraRig& rig() const { return rig_; }
  /// The silhouettes of a frame, one per camera of the rig in its distorted picture; nothing where
  /// a camera has no picture. Where they contradict each other, something else that stands out may
  /// be the hand (agreeing_pieces.h); given masks are taken as they are. Reports, where asked for,
  /// are one per camera as well; a given mask is sure.
  std::vector<std::optional<Silhouette>> segment(
      const TakeFrame& frame, std::vector<SegmentationReport>* reports = nullptr) const;
  /// What the camera would see without its lens's distortion (undistortion.h).
  HullView undistorted(const Silhouette& silhouette, std::size_t camera) const;

 private:
  Silhouette segment_picture(const CameraImage& picture, std::size_t camera,
                             SegmentationReport& report) const;
  void choose_agreeing(const TakeFrame& frame, std::vector<std::optional<Silhouette>>& silhouettes,
                       std::vector<SegmentationReport>& reports) const;

  SegmentationMethod method_;
  CameraRig rig_;
  std::vector<CameraImage> backgrounds_;  // by camera, for that method
  std::vector<Undistortion> undistortions_;
};

}  // namespace tegata
