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

// The same two cameras as other tools write them, after the byte that says which (see
// fuzz_calibration_import.cpp).
constexpr const char* kColmap =
    "\3# cameras\n1 OPENCV 640 480 700 700 320 240 -0.1 0.01 0 0\n"
    "2 SIMPLE_RADIAL 640 480 700 320 240 -0.1\n|1 1 0 0 0 0 0 1 1 a.png\n1 2 -1\n"
    "2 0.7 0 0.714142842854285 0 0 0 1 2 b.png\n\n";
constexpr const char* kEasyMocap =
    "\1%YAML:1.0\n---\nnames:\n  - \"01\"\n  - \"02\"\nK_01: !!opencv-matrix\n  rows: 3\n"
    "  cols: 3\n  dt: d\n  data: [ 700., 0., 320., 0., 700., 240., 0., 0., 1. ]\n"
    "dist_01: [0, 0, 0, 0, 0]\nR_01: [0.1, 0, 0]\nT_01: [0, 0, 1]\nH_01: 480\nW_01: 640\n"
    "K_02: [700, 0, 320, 0, 700, 240, 0, 0, 1]\ndist_02: [0, 0, 0, 0, 0]\n"
    "Rot_02: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT_02: [0, 0, 1]\n";
constexpr const char* kKalibr =
    "\2cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.1, 0, 0, 0]\n"
    "  distortion_model: equidistant\n  intrinsics: [700, 700, 320, 240]\n"
    "  resolution: [640, 480]\ncam1:\n  T_cn_cnm1:\n  - [1, 0, 0, 0.1]\n  - [0, 1, 0, 0]\n"
    "  - [0, 0, 1, 0]\n  - [0, 0, 0, 1]\n  camera_model: pinhole\n"
    "  distortion_coeffs: [0.1, 0, 0, 0]\n  distortion_model: radtan\n"
    "  intrinsics: [700, 700, 320, 240]\n  resolution: [640, 480]\n";
constexpr const char* kOpenCvXml =
    "\1<?xml version=\"1.0\"?>\n<opencv_storage>\n<!-- two -->\n<a><name>\"left\"</name>"
    "<image_width>640</image_width><image_height>480</image_height>\n"
    "<camera_matrix type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt>\n"
    "<data>700. 0. 320. 0. 700. 240. 0. 0. 1.</data></camera_matrix>\n"
    "<distortion_coefficients>0 0 0 0</distortion_coefficients><R>0 0 0</R><T>0 0 1</T></a>\n"
    "<b><K>700. 0. 320. 0. 700. 240. 0. 0. 1.</K><D>0. 0. 0. 0.</D><R>0 0.1 0</R>"
    "<T><_>0</_><_>0</_><_>1</_></T></b></opencv_storage>\n";

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
  const std::filesystem::path imports = seeds_of(folder, "calibration_import");
  std::string colmap = kColmap;
  colmap[colmap.find('|')] = '\0';
  std::ofstream(imports / "colmap", std::ios::binary) << colmap;
  std::ofstream(imports / "easymocap.yml") << kEasyMocap;
  std::ofstream(imports / "kalibr.yaml") << kKalibr;
  std::ofstream(imports / "opencv.xml") << kOpenCvXml;
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
