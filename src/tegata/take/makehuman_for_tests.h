// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "tegata/hand/skeleton.h"
#include "tegata/take/scanned_hand.h"

namespace tegata {

/// The right hand of the MakeHuman base mesh, cut out where its rig's hand moves it more than
/// the arm does, with the
/// joints that the rig puts into the mesh, and each vertex's main bone by the rig's weights.
struct MakeHumanHand {
  ScannedHand scan;
  std::vector<int> rig_bones;  ///< one a vertex
};

namespace makehuman {

/// "hand_r", "thumb_01_r" ... in the order of bone_names().
inline std::vector<std::string> bones() {
  std::vector<std::string> names = {"hand_r"};
  for (const char* digit : {"thumb", "index", "middle", "ring", "pinky"}) {
    for (const char* joint : {"_01_r", "_02_r", "_03_r"})
      names.push_back(digit + std::string(joint));
  }
  return names;
}

/// "joint-r-hand", "joint-r-finger-1-1" ... in the order of keypoint_names(): small cubes in the
/// mesh, with a joint in the middle of each.
inline std::vector<std::string> cubes() {
  std::vector<std::string> names = {"joint-r-hand"};
  for (int digit = 1; digit <= 5; ++digit) {
    for (int joint = 1; joint <= 4; ++joint) {
      names.push_back("joint-r-finger-" + std::to_string(digit) + "-" + std::to_string(joint));
    }
  }
  return names;
}

struct Body {
  std::vector<Eigen::Vector3d> vertices;
  std::map<std::string, std::vector<std::vector<std::uint32_t>>> faces;  // by group
};

inline Body read_body(const std::filesystem::path& file) {
  Body body;
  std::ifstream stream(file);
  std::string group;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key == "g") words >> group;
    if (key == "v") {
      Eigen::Vector3d& vertex = body.vertices.emplace_back();
      words >> vertex.x() >> vertex.y() >> vertex.z();
    }
    if (key == "f") {
      auto& face = body.faces[group].emplace_back();
      while (words >> word) face.push_back(static_cast<std::uint32_t>(std::stoul(word) - 1));
    }
  }
  return body;
}

inline Eigen::Vector3d middle_of(const Body& body, const std::string& cube) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const auto& face : body.faces.at(cube)) {  // each corner is in three faces
    for (const std::uint32_t corner : face) {
      sum += body.vertices[corner];
      ++count;
    }
  }
  return sum / count;
}

}  // namespace makehuman

/// Metres. `folder` is that of the recordings and models from elsewhere.
inline MakeHumanHand makehuman_hand(const std::filesystem::path& folder) {
  constexpr double kMetresPerUnit = 0.1;
  const makehuman::Body body = makehuman::read_body(folder / "base.obj");
  std::ifstream stream(folder / "weights.game_engine.json");
  const nlohmann::json weights = nlohmann::json::parse(stream).at("weights");
  std::vector<std::array<double, kBoneCount>> parts(body.vertices.size());
  const std::vector<std::string> bones = makehuman::bones();
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    for (const auto& entry : weights.at(bones[bone])) {
      parts[entry.at(0).get<std::size_t>()][bone] = entry.at(1).get<double>();
    }
  }
  MakeHumanHand hand;
  hand.scan.name = "makehuman";
  const std::vector<std::string> cubes = makehuman::cubes();
  for (std::size_t k = 0; k < cubes.size(); ++k) {
    hand.scan.keypoints[k] = kMetresPerUnit * makehuman::middle_of(body, cubes[k]);
  }
  std::map<std::uint32_t, std::uint32_t> place;
  for (const auto& face : body.faces.at("body")) {
    const bool is_hand = std::all_of(face.begin(), face.end(), [&](std::uint32_t corner) {
      return std::accumulate(parts[corner].begin(), parts[corner].end(), 0.0) > 0.5;
    });
    if (!is_hand) continue;
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t corner : face) {
      const auto [entry, is_new] =
          place.emplace(corner, static_cast<std::uint32_t>(hand.scan.surface.vertices.size()));
      if (is_new) {
        hand.scan.surface.vertices.push_back(kMetresPerUnit * body.vertices[corner]);
        const auto& part = parts[corner];
        hand.rig_bones.push_back(
            static_cast<int>(std::max_element(part.begin(), part.end()) - part.begin()));
      }
      corners.push_back(entry->second);
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      hand.scan.surface.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  return hand;
}

}  // namespace tegata
