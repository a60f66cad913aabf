// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/scanned_hand.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/hand/skeleton_from_keypoints.h"
#include "tegata/hand/skin_links.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

constexpr std::array<std::string_view, 5> kScanKeys = {"name", "mesh", "hand", "metres_per_unit",
                                                       "keypoints"};
// No joint of a hand is deeper in it than this; the wrist's centre is the deepest.
constexpr double kDeepestJoint = 0.05;     // [m]
constexpr double kShortestForearm = 0.02;  // of the bones that the wrist's end is linked to [m]
// Half the distance between the forearm's bones by that between the index and the little finger's
// knuckles: as in the built-in hand of the mean adult.
constexpr double kWristByKnuckles = 0.5;

TriangleMesh read_mesh(const TomlTable& root, const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".ply") return read_ply(file);
  if (ending == ".obj") return read_obj(file);
  root.fail("mesh", text("'", file.filename().string(), "'"), "a file that ends in .ply or .obj");
}

Side read_side(const TomlTable& root) {
  const std::string name = root.string("hand");
  for (const Side side : {Side::right, Side::left}) {
    if (name == side_name(side)) return side;
  }
  root.fail("hand", "'" + name + "'", "'right' or 'left'");
}

void scale(ScannedHand& scan, double metres_per_unit) {
  for (Eigen::Vector3d& vertex : scan.surface.vertices) vertex *= metres_per_unit;
  for (Eigen::Vector3d& keypoint : scan.keypoints) keypoint *= metres_per_unit;
}

void check_depths(const ScannedHand& scan) {
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& vertex : scan.surface.vertices) {
      nearest = std::min(nearest, (vertex - scan.keypoints[k]).norm());
    }
    if (!(nearest <= kDeepestJoint)) {
      throw Error("keypoint ", keypoint_names()[k], " is ", nearest,
                  " m from the nearest vertex, expected at most ", kDeepestJoint,
                  ": are mesh and keypoints in the same frame, and is metres_per_unit right?");
    }
  }
}

/// The sign of the volume as seen from the middle of the vertices, so that a hole at the wrist does
/// not count.
bool is_inside_out(TriangleMesh mesh) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : mesh.vertices) middle += vertex;
  middle /= static_cast<double>(mesh.vertices.size());
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex -= middle;
  return enclosed_volume(mesh) < 0.0;
}

HandModel rigged_model(const ScannedHand& scan) {
  if (scan.surface.triangles.empty()) throw Error("the mesh has no triangles");
  check_mesh(scan.surface);
  const FoundSkeleton found = skeleton_from_keypoints(scan.keypoints, scan.side);
  HandModel model;
  model.name = scan.name;
  model.skeleton = found.skeleton;
  model.rest_angles = found.angles;
  model.rest_surface = without_unused_vertices({.vertices = scan.surface.vertices,
                                                .triangles = scan.surface.triangles,
                                                .normals = {},
                                                .unproven = {}});
  check_depths(scan);
  if (is_inside_out(model.rest_surface)) {
    for (Triangle& triangle : model.rest_surface.triangles) std::swap(triangle[1], triangle[2]);
  }
  const Rigid3d hand_from_scan = found.source_from_hand.inverse();
  double forearm = kShortestForearm;
  for (Eigen::Vector3d& vertex : model.rest_surface.vertices) {
    vertex = hand_from_scan * vertex;
    forearm = std::max(forearm, -vertex.y());
  }
  model.rest_surface.normals = vertex_normals(model.rest_surface);
  const double knuckles = (scan.keypoints[17] - scan.keypoints[5]).norm();
  const BoneSegments segments =
      bone_segments(found.skeleton, found.angles, forearm, kWristByKnuckles * knuckles);
  model.links.reserve(model.rest_surface.vertices.size());
  for (const Eigen::Vector3d& vertex : model.rest_surface.vertices) {
    model.links.push_back(link_to_bones(segments, vertex));
  }
  check_hand(model);
  return model;
}

}  // namespace

ScannedHand read_scanned_hand(const std::filesystem::path& file) {
  const TomlTable root = TomlTable::read(file);
  root.expect_keys(kScanKeys);
  ScannedHand scan;
  scan.name = root.has("name") ? root.string("name") : file.stem().string();
  scan.side = read_side(root);
  const TomlTable keypoints = root.table("keypoints");
  keypoints.expect_keys(keypoint_names());
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    scan.keypoints[k] = keypoints.vector3(keypoint_names()[k]);
  }
  scan.surface = read_mesh(root, file.parent_path() / root.string("mesh"));
  scale(scan, root.has("metres_per_unit") ? root.positive_number("metres_per_unit") : 1.0);
  return scan;
}

HandModel rigged(const ScannedHand& scan) {
  try {
    return rigged_model(scan);
  } catch (const Error& error) {
    throw Error("scanned hand '", scan.name, "': ", error.what());
  }
}

}  // namespace tegata
