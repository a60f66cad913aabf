// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <type_traits>

#include "tegata/export/base64.h"
#include "tegata/export/frame_doubts.h"
#include "tegata/mesh/simplify.h"

namespace tegata {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostHandTriangles = 12'000;
constexpr std::size_t kMostHulls = 300, kMostHullBytes = 4'000'000;

/// Numbers as base64 of their little-endian bytes.
template <typename T>
std::string packed(const std::vector<T>& numbers) {
  static_assert(std::is_arithmetic_v<T>);
  const auto bytes = std::as_bytes(std::span(numbers));
  return encode_base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

ordered_json rounded_list(const auto& values, double places) {
  auto list = ordered_json::array();
  for (const double value : values) list.push_back(std::round(value * places) / places);
  return list;
}

ordered_json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json rotation_json(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

void append(std::vector<float>& numbers, const Eigen::Vector3d& v) {
  for (const double x : v) numbers.push_back(static_cast<float>(x));
}

/// The hand's surface, no finer than a page needs, and what moves its vertices.
ordered_json hand_json(const HandModel& hand, std::vector<std::string>& limits) {
  const TriangleMesh& fine = hand.rest_surface;
  const TriangleMesh surface = simplify(fine, kMostHandTriangles);
  if (surface.triangles.size() < fine.triangles.size()) {
    limits.push_back(fmt::format("The hand is drawn with {} of its {} triangles.",
                                 surface.triangles.size(), fine.triangles.size()));
  }
  // Simplifying keeps some of the vertices where they are.
  using Place = std::array<double, 3>;
  const auto place = [](const Eigen::Vector3d& v) { return Place{v.x(), v.y(), v.z()}; };
  std::map<Place, std::size_t> vertex_at;
  for (std::size_t i = 0; i < fine.vertices.size(); ++i) vertex_at[place(fine.vertices[i])] = i;

  std::vector<float> vertices, weights;
  std::vector<std::uint8_t> bones;
  std::vector<std::uint32_t> triangles;
  for (const Eigen::Vector3d& vertex : surface.vertices) {
    append(vertices, vertex);
    const SkinLinks& links = hand.links[vertex_at.at(place(vertex))];
    for (std::size_t i = 0; i < links.bones.size(); ++i) {
      bones.push_back(static_cast<std::uint8_t>(links.bones[i]));
      weights.push_back(static_cast<float>(links.weights[i]));
    }
  }
  for (const Triangle& triangle : surface.triangles) {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  return {{"vertices", packed(vertices)},
          {"triangles", packed(triangles)},
          {"bones", packed(bones)},
          {"weights", packed(weights)}};
}

/// For each bone the rotation (w, x, y, z) and the translation from the rest surface to the world.
std::string bones_of_pose(const HandModel& hand, const HandPose& pose) {
  const auto rest = bone_transforms(hand.skeleton, hand.rest_angles);
  const auto posed = bone_transforms(hand.skeleton, pose.angles);
  std::vector<float> numbers;
  for (std::size_t bone = 0; bone < rest.size(); ++bone) {
    const Rigid3d move = pose.world_from_hand * posed[bone] * rest[bone].inverse();
    const Eigen::Quaterniond& q = move.rotation;
    for (const double x : {q.w(), q.x(), q.y(), q.z()}) numbers.push_back(static_cast<float>(x));
    append(numbers, move.translation);
  }
  return packed(numbers);
}

ordered_json hull_json(const TriangleMesh& hull) {
  constexpr double kSteps = 65535.0;
  const Eigen::AlignedBox3d box = bounding_box(hull);
  std::vector<std::uint16_t> vertices;
  std::vector<std::uint32_t> triangles;
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    for (int i = 0; i < 3; ++i) {
      const double size = box.sizes()[i];
      const double share = size > 0.0 ? (vertex[i] - box.min()[i]) / size : 0.0;
      vertices.push_back(static_cast<std::uint16_t>(std::lround(kSteps * share)));
    }
  }
  for (const Triangle& triangle : hull.triangles) {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  return {{"low", vector_json(box.min())},
          {"high", vector_json(box.max())},
          {"vertices", packed(vertices)},
          {"triangles", hull.vertices.size() > 65536 ? packed(triangles)
                                                     : packed(std::vector<std::uint16_t>(
                                                           triangles.begin(), triangles.end()))}};
}

/// Each line as its number of points and their positions in the window, which is 1 wide and high,
/// from -8 to 9 in 65535 steps.
std::string packed_outlines(const std::vector<Outline>& outlines, const PictureWindow& window) {
  const auto step = [](double share) {
    return static_cast<std::uint16_t>(
        std::lround(std::clamp((share + 8.0) / 17.0, 0.0, 1.0) * 65535.0));
  };
  std::vector<std::uint16_t> numbers;
  for (const Outline& outline : outlines) {
    constexpr std::size_t kMostPoints = 65535;
    const std::size_t count = std::min(kMostPoints, outline.size());
    numbers.push_back(static_cast<std::uint16_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      numbers.push_back(step((outline[i].x() + 0.5 - window.left) / window.width));
      numbers.push_back(step((outline[i].y() + 0.5 - window.top) / window.height));
    }
  }
  return packed(numbers);
}

ordered_json cameras_json(const ReportContent& content) {
  auto list = ordered_json::array();
  for (std::size_t c = 0; c < content.rig.size(); ++c) {
    const Camera& camera = content.rig[c];
    const PictureWindow window = c < content.pictures.windows.size()
                                     ? content.pictures.windows[c]
                                     : PictureWindow{0, 0, camera.width, camera.height};
    list.push_back({{"name", camera.name},
                    {"size", {camera.width, camera.height}},
                    {"focal", {camera.fx, camera.fy}},
                    {"center", {camera.cx, camera.cy}},
                    {"rotation", rotation_json(camera.camera_from_world.rotation)},
                    {"translation", vector_json(camera.camera_from_world.translation)},
                    {"window", {window.left, window.top, window.width, window.height}}});
  }
  return list;
}

ordered_json frame_json(const ReportContent& content, const FrameDoubt& doubt) {
  const ResultFrame& frame = content.result.frames[doubt.frame];
  ordered_json json = {{"frame", frame.name},
                       {"time", std::round(1e6 * frame.time) / 1e6},
                       {"status", frame.status},
                       {"severity", std::round(1e3 * doubt.severity) / 1e3},
                       {"doubts", doubt.reasons}};
  if (frame.pose) {
    json["bones"] = bones_of_pose(content.hand, *frame.pose);
    json["angles"] = rounded_list(frame.pose->angles, 1e5);
    json["keypoints"] = ordered_json::array();
    for (const Eigen::Vector3d& point : frame.keypoints) {
      json["keypoints"].push_back(rounded_list(point, 1e6));
    }
    json["support"] = rounded_list(frame.support, 1e3);
    json["overlap"] = ordered_json::object();
    for (const auto& [camera, overlap] : frame.silhouette_iou) {
      json["overlap"][camera] = std::round(1e3 * overlap) / 1e3;
    }
  }
  return json;
}

/// Of so many frames, whatever their hulls: of how many one keeps it.
std::size_t least_hull_step(std::size_t frame_count) {
  return std::max<std::size_t>(1, (frame_count + kMostHulls - 1) / kMostHulls);
}

/// Of how many frames one keeps its hull, so that all of them fit into the page.
std::size_t hull_step(const ReportContent& content) {
  const std::vector<ResultFrame>& frames = content.result.frames;
  const std::size_t least = least_hull_step(frames.size());
  for (std::size_t step = least;; step += least) {
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < frames.size(); i += step) {
      const auto hull = content.hulls.find(frames[i].name);
      if (hull == content.hulls.end()) continue;
      bytes += 4 * (6 * hull->second.vertices.size() + 6 * hull->second.triangles.size()) / 3;
    }
    if (bytes <= kMostHullBytes || step >= frames.size()) return step;
  }
}

ordered_json frames_json(const ReportContent& content, const std::vector<FrameDoubt>& doubts,
                         std::vector<std::string>& limits) {
  auto list = ordered_json::array();
  const std::size_t step = hull_step(content);
  for (const FrameDoubt& doubt : doubts) {
    list.push_back(frame_json(content, doubt));
    const auto hull = content.hulls.find(content.result.frames[doubt.frame].name);
    if (hull != content.hulls.end() && doubt.frame % step == 0) {
      list.back()["hull"] = hull_json(hull->second);
    }
  }
  if (step > 1 && !content.hulls.empty()) {
    limits.push_back(fmt::format("Hulls of one in {} frames are in this page.", step));
  }
  for (const ReportPicture& picture : content.pictures.pictures) {
    const PictureWindow& window = content.pictures.windows[picture.camera];
    list[picture.frame]["pictures"].push_back(
        {{"camera", picture.camera},
         {"jpeg", encode_base64(picture.jpeg)},
         {"hand", packed_outlines(picture.hand, window)},
         {"silhouette", packed_outlines(picture.silhouette, window)}});
  }
  return list;
}

}  // namespace

std::set<std::string> frames_with_hull(const std::vector<std::string>& frames) {
  std::set<std::string> chosen;
  const std::size_t step = least_hull_step(frames.size());
  for (std::size_t i = 0; i < frames.size(); i += step) chosen.insert(frames[i]);
  return chosen;
}

TriangleMesh report_hull(const TriangleMesh& hull, std::size_t frame_count) {
  constexpr std::size_t kAllTriangles = 150'000, kFewest = 400, kMost = 2000;
  const std::size_t count = kAllTriangles / std::max<std::size_t>(1, frame_count);
  TriangleMesh coarse = simplify(hull, std::clamp(count, kFewest, kMost));
  coarse.normals.clear();
  coarse.unproven.clear();
  return coarse;
}

std::string report_json(const ReportContent& content) {
  const Result& result = content.result;
  const std::vector<FrameDoubt> doubts = frame_doubts(result);
  const FitVerdict verdict = fit_verdict(result, doubts);
  std::vector<std::string> limits = content.pictures.limits;
  if (content.rig.empty()) {
    limits.emplace_back("Made without the take: no cameras and no pictures.");
  }
  ordered_json json;
  json["format"] = "tegata-report";
  json["version"] = 1;
  json["tegata"] = TEGATA_VERSION;
  json["take"] = result.take;
  json["hand"] = side_name(result.side);
  json["model"] = {{"name", result.model_name}, {"scale", result.model_scale}};
  if (result.model_scale_standard_deviation) {
    json["model"]["scale_standard_deviation"] = *result.model_scale_standard_deviation;
  }
  json["verdict"] = {{"word", verdict.word},
                     {"sentence", verdict.sentence},
                     {"trusted", verdict.trusted},
                     {"mean_overlap", verdict.mean_overlap},
                     {"worst", worst_frame(doubts)}};
  json["joint_names"] = angle_names();
  json["keypoint_names"] = keypoint_names();
  json["bone_names"] = bone_names();
  json["grasp"] = {{"angles", rounded_list(result.grasp_angles, 1e5)},
                   {"standard_deviations", rounded_list(result.grasp_standard_deviations, 1e5)}};
  json["cameras"] = cameras_json(content);
  json["hand_surface"] = hand_json(content.hand, limits);
  json["frames"] = frames_json(content, doubts, limits);
  json["report"] = {{"iterations", result.iterations},
                    {"termination", result.termination},
                    {"seconds", result.seconds}};
  json["limits"] = limits;

  // Names come from files and need not be UTF-8.
  const std::string text = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace tegata
