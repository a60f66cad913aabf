// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// Reads a skinned hand from GLB or glTF: joints by their 25 WebXR names (wrist, thumb-metacarpal,
/// ..., pinky-finger-tip), in any order and hierarchy; the finger metacarpals move with the palm.
/// The hand's frame, axes and zero angles are made from where the nodes put the joints
/// (skeleton_from_keypoints.h); a file of write_hand_gltf has them noted and gives back the very
/// same. Throws Error naming the file and what is missing or out of range in it. `side` says which
/// hand it is; joints that can only be those of the other hand are an Error.
HandModel read_hand_gltf(const std::filesystem::path& file, Side side);

/// The same from the bytes of a file that refers to no other file. `name` is what the hand and
/// errors are called by.
HandModel parse_hand_gltf(std::string_view bytes, Side side, const std::string& name);

/// One frame of an animation.
struct HandKeyframe {
  double time = 0.0;  ///< [s]
  HandPose pose;
  bool is_hidden = false;  ///< there is no pose: from here to the next keyframe nothing is shown
};

/// Writes a skinned hand with WebXR joint names and axes (-z along the bone, y out of its back)
/// and, unless there are no keyframes, one animation: y up, metres, the world turned from OpenCV's
/// axes (y down) by half a turn about x. The nodes are in the model's rest pose. What is hidden is
/// scaled to nothing, as glTF says for that. Cameras become glTF's, which know neither a principal
/// point nor lens distortion; both stand in their `extras`. Binary unless the file's name ends in
/// .gltf. Throws Error where times do not increase from 0 on or the file cannot be written.
void write_hand_gltf(const HandModel& model, const std::vector<HandKeyframe>& keyframes,
                     const std::filesystem::path& file, const CameraRig& cameras = {});

}  // namespace tegata
