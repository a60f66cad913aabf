// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/result_folder.h"

#include <vector>

#include "tegata/base/error.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/mesh/mesh_file.h"

namespace tegata {

void write_result_files(const Result& result, const HandModel& hand,
                        const std::filesystem::path& folder, const CameraRig& cameras) {
  write_result_json(result, folder / "result.json");
  write_angles_csv(result, folder / "angles.csv");

  const std::filesystem::path meshes = folder / "meshes";
  std::error_code failure;
  std::filesystem::create_directory(meshes, failure);
  if (failure) throw Error(meshes.string(), ": cannot be made: ", failure.message());
  std::vector<HandKeyframe> keyframes;
  for (const ResultFrame& frame : result.frames) {
    HandKeyframe& keyframe = keyframes.emplace_back();
    keyframe.time = frame.time - result.frames.front().time;
    keyframe.is_hidden = !frame.pose;
    if (!frame.pose) continue;
    keyframe.pose = *frame.pose;
    write_ply(PosedHand(hand, *frame.pose).surface(), meshes / (frame.name + ".ply"));
  }
  if (!result.object.triangles.empty()) {
    write_ply(result.object, folder / "object.ply", result.object_confidence);
  }
  write_hand_gltf(hand, keyframes, folder / "hand.glb", cameras);
}

}  // namespace tegata
