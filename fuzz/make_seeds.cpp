// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes what the fuzz targets start from: small files as this project writes them itself.
// usage: make_seeds FOLDER     a folder a target
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/test_hand.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/result.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/take_info.h"

namespace tegata {
namespace {

// What this project reads and does not write: text, polygons, other properties, comments.
constexpr const char* kAsciiPly =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty double x\n"
    "property double y\nproperty double z\nproperty uchar red\nelement face 1\n"
    "property list uchar uint vertex_index\nelement edge 1\nproperty int vertex1\n"
    "end_header\n0 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0 255\n4 0 1 2 3\n7\n";

/// A folder of the seeds of one target, made where it is not there.
std::filesystem::path seeds_of(const std::filesystem::path& folder, const char* target) {
  std::filesystem::create_directories(folder / target);
  return folder / target;
}

/// A GLB as its JSON, a zero byte and its binary chunk, which fuzz_glb takes as well.
void write_parts(const std::string& glb, const std::filesystem::path& file) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  std::uint32_t length = 0;
  std::memcpy(&length, &glb.at(kHeader), sizeof length);
  const std::size_t json = kHeader + kChunkHeader;
  std::ofstream(file, std::ios::binary)
      << glb.substr(json, length) << '\0' << glb.substr(json + length + kChunkHeader);
}

Camera camera(const std::string& name) {
  Camera made;
  made.name = name;
  made.width = 640;
  made.height = 480;
  made.fx = made.fy = 700.0;
  made.cx = 320.0;
  made.cy = 240.0;
  return made;
}

Result result_of(const HandModel& hand) {
  Result result;
  result.take = "take";
  result.model_name = hand.name;
  result.frames.resize(2);
  ResultFrame& frame = result.frames[0];
  frame.name = "000000";
  frame.status = "ok";
  frame.pose = HandPose{};
  frame.keypoints = posed_keypoints(hand.skeleton, *frame.pose);
  frame.views = {"left", "right"};
  frame.silhouette_iou = {{"left", 0.9}};
  result.frames[1].name = "000001";
  result.frames[1].status = "no hand found";
  return result;
}

void make_seeds(const std::filesystem::path& folder) {
  const HandModel hand = test_hand();
  const std::filesystem::path glb = seeds_of(folder, "glb");
  write_hand_gltf(hand, {}, glb / "right.glb");
  write_hand_gltf(mirrored(hand), {HandKeyframe{}}, glb / "left.glb");
  write_parts(read_file(glb / "right.glb"), glb / "right.parts");

  const std::filesystem::path ply = seeds_of(folder, "ply");
  TriangleMesh mesh = hand.rest_surface;
  mesh.unproven.assign(mesh.vertices.size(), 1);
  write_ply(mesh, ply / "hand.ply");
  std::ofstream(ply / "ascii.ply") << kAsciiPly;

  write_calibration({camera("left"), camera("right")},
                    seeds_of(folder, "calibration") / "calibration.toml");
  TakeInfo info;
  info.name = "take";
  info.side = Side::left;
  info.initial_landmarks = InitialLandmarks{{0.0, 0.0, 1.0}, {0.0, 0.1, 1.0}, {0.1, 0.1, 1.0}};
  info.segmentation = SegmentationMethod::infrared;
  write_take_info(info, seeds_of(folder, "take_toml") / "take.toml");
  write_result_json(result_of(hand), seeds_of(folder, "result_json") / "result.json");
}

}  // namespace
}  // namespace tegata

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_seeds FOLDER\n");
    return 2;
  }
  try {
    tegata::make_seeds(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_seeds: %s\n", error.what());
    return 1;
  }
  return 0;
}
