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
#include <vector>

#include "seed_texts.h"
#include "tegata/base/text.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/test_hand.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/hand_shape_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/result.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/take_info.h"
#include "tegata/take/test_video.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

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

/// A text of seed_texts.h.
void write_seed(std::string content, const std::filesystem::path& file) {
  const std::size_t bar = content.find('|');
  if (bar != std::string::npos) content[bar] = '\0';
  std::ofstream(file, std::ios::binary) << content;
}

void make_texts(const std::filesystem::path& folder) {
  write_seed(kColmap, seeds_of(folder, "colmap") / "colmap");
  const std::filesystem::path easymocap = seeds_of(folder, "easymocap");
  write_seed(kEasyMocap, easymocap / "one");
  write_seed(kEasyMocapPair, easymocap / "two");
  write_seed(kKalibr, seeds_of(folder, "kalibr") / "camchain.yaml");
  const std::filesystem::path opencv = seeds_of(folder, "opencv");
  write_seed(kOpenCvXml, opencv / "two.xml");
  write_seed(kOpenCvJson, opencv / "two.json");
  write_seed(kOpenCvStereo, opencv / "stereo");
  const std::filesystem::path board = seeds_of(folder, "board");
  write_seed(kBoard, board / "board.toml");
  write_seed(kCaliscopeBoard, board / "charuco.toml");
}

/// Colour or gray, as large as a few of JPEG's blocks; an even number of pixels, for videos.
CameraImage picture(int channels, int bits) {
  CameraImage made{Image<std::uint16_t>(24, 18, 0, channels), bits};
  std::uint32_t value = 0;
  for (std::uint16_t& v : made.values.values()) {
    v = static_cast<std::uint16_t>((value += 7u) & (bits == 8 ? 0xffu : 0xffffu));
  }
  return made;
}

void make_pictures(const std::filesystem::path& folder) {
  const std::filesystem::path pictures = seeds_of(folder, "picture");
  for (const int channels : {1, 3}) {
    for (const int bits : {8, 16}) {
      const std::string stem = text(channels, "-", bits);
      write_picture(picture(channels, bits), pictures / (stem + ".png"));
      write_picture(picture(channels, bits), pictures / (stem + ".tif"));
      if (bits == 8) write_picture(picture(channels, bits), pictures / (stem + ".jpg"));
    }
  }
  const std::vector<CameraImage> three(3, picture(3, 8));
  std::ofstream(seeds_of(folder, "avi") / "three.avi", std::ios::binary) << motion_jpeg_avi(three);
}

/// A mesh beside the seeds is named by where it lies: no bytes hold both.
void make_scan(const HandModel& hand, const std::filesystem::path& folder) {
  const std::filesystem::path mesh = std::filesystem::absolute(folder / "scanned_hand.ply");
  write_ply(hand.rest_surface, mesh);
  std::string content = text("name = \"scan\"\nmesh = \"", mesh.string(),
                             "\"\nhand = \"right\"\nmetres_per_unit = 1.0\n[keypoints]\n");
  const HandPose rest{Rigid3d{}, hand.rest_angles};
  const auto keypoints = posed_keypoints(hand.skeleton, rest);
  for (std::size_t k = 0; k < keypoints.size(); ++k) {
    const Eigen::Vector3d& at = keypoints[k];
    content += text(keypoint_names()[k], " = [", at.x(), ", ", at.y(), ", ", at.z(), "]\n");
  }
  write_seed(content, seeds_of(folder, "scanned_hand") / "scan.toml");
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
  write_obj(hand.rest_surface, seeds_of(folder, "obj") / "hand.obj");
  make_scan(hand, folder);
  make_texts(folder);
  make_pictures(folder);

  write_calibration({camera("left"), camera("right")},
                    seeds_of(folder, "calibration") / "calibration.toml");
  TakeInfo info;
  info.name = "take";
  info.side = Side::left;
  info.initial_landmarks = InitialLandmarks{{0.0, 0.0, 1.0}, {0.0, 0.1, 1.0}, {0.1, 0.1, 1.0}};
  info.segmentation = SegmentationMethod::infrared;
  write_take_info(info, seeds_of(folder, "take_toml") / "take.toml");
  write_truth_json(
      {Side::left, {{"000000", posed_keypoints(hand.skeleton, HandPose{}), JointAngles::Zero()}}},
      seeds_of(folder, "truth_json") / "truth.json");
  HandShapeFile shape;
  shape.name = "somebody";
  shape.standard_deviations = shape_prior().deviation;
  write_hand_shape(shape, seeds_of(folder, "hand_shape") / "shape.toml");
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
