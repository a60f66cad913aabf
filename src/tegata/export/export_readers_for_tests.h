// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What other programs do with an export, in few lines and without the code that wrote it: each
// reader gives a frame's keypoints by name, in metres in the world of result.json.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tegata/take/result.h"

#include "tegata/base/angle.h"

namespace tegata {

/// Empty where a frame has no pose.
using NamedPoints = std::map<std::string, Eigen::Vector3d>;

/// Expects each frame's keypoints where the result has them, and none where it has none.
inline void expect_keypoints(const std::vector<NamedPoints>& frames, const Result& result,
                             double tolerance = 1e-6) {
  ASSERT_EQ(frames.size(), result.frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!result.frames[i].pose) {
      EXPECT_TRUE(frames[i].empty()) << "frame " << i;
      continue;
    }
    ASSERT_EQ(frames[i].size(), keypoint_names().size()) << "frame " << i;
    for (std::size_t k = 0; k < keypoint_names().size(); ++k) {
      const Eigen::Vector3d& got = frames[i].at(std::string(keypoint_names()[k]));
      EXPECT_LT((got - result.frames[i].keypoints[k]).norm(), tolerance)
          << keypoint_names()[k] << " in frame " << i << " is at " << got.transpose();
    }
  }
}

inline std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == separator) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  lines.pop_back();  // after the last line break
  return lines;
}

/// A CSV table's rows by column names; cells may be quoted.
inline std::vector<std::map<std::string, std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, std::vector<std::string>(1));
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && is_quoted && i + 1 < text.size() && text[i + 1] == '"') {
      lines.back().back() += text[++i];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      lines.back().emplace_back();
    } else if (c == '\n' && !is_quoted) {
      lines.emplace_back(1);
    } else {
      lines.back().back() += c;
    }
  }
  lines.pop_back();
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].size(), lines[0].size()) << "row " << i;
    for (std::size_t j = 0; j < lines[0].size() && j < lines[i].size(); ++j) {
      if (j == 0) rows.emplace_back();
      rows.back()[lines[0][j]] = lines[i][j];
    }
  }
  return rows;
}

inline Eigen::Vector3d numbers3(const std::string& text) {
  std::istringstream stream(text);
  Eigen::Vector3d vector = Eigen::Vector3d::Constant(std::nan(""));
  stream >> vector.x() >> vector.y() >> vector.z();
  return vector;
}

/// y up to the world of result.json, both ways the same.
inline Eigen::Vector3d y_down(const Eigen::Vector3d& point) {
  return {point.x(), -point.y(), -point.z()};
}

inline std::vector<NamedPoints> csv_keypoints(const std::string& text) {
  std::vector<NamedPoints> frames;
  for (const auto& row : csv_rows(text)) {
    NamedPoints& points = frames.emplace_back();
    for (const std::string_view name : keypoint_names()) {
      const std::string key(name);
      if (row.at(key + "_x_m").empty()) continue;
      points[key] = {std::stod(row.at(key + "_x_m")), std::stod(row.at(key + "_y_m")),
                     std::stod(row.at(key + "_z_m"))};
    }
  }
  return frames;
}

inline std::vector<NamedPoints> trc_keypoints(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<NamedPoints> frames;
  const std::vector<std::string> names = split(lines.at(3), '\t');
  EXPECT_EQ(split(lines.at(2), '\t').at(4), "mm");
  for (std::size_t i = 6; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], '\t');
    NamedPoints& points = frames.emplace_back();
    for (std::size_t j = 2; j + 2 < cells.size(); j += 3) {
      if (cells[j].empty()) continue;
      points[names.at(j)] =
          1e-3 * y_down({std::stod(cells[j]), std::stod(cells[j + 1]), std::stod(cells[j + 2])});
    }
  }
  return frames;
}

/// A MOT has no bones: they are the hand's.
inline std::vector<NamedPoints> mot_keypoints(const std::string& text, const Skeleton& skeleton) {
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line) && line != "endheader") continue;
  std::getline(stream, line);
  const std::vector<std::string> names = split(line, '\t');
  std::vector<NamedPoints> frames;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = split(line, '\t');
    std::map<std::string, double> row;
    for (std::size_t j = 0; j < names.size(); ++j) row[names[j]] = std::stod(cells.at(j));
    NamedPoints& points = frames.emplace_back();
    if (std::isnan(row.at("hand_tx"))) continue;
    using Turn = Eigen::AngleAxisd;
    HandPose pose;
    pose.world_from_hand.rotation = Turn(std::numbers::pi, Eigen::Vector3d::UnitX()) *
                                    Turn(kDegree * row.at("hand_rz"), Eigen::Vector3d::UnitZ()) *
                                    Turn(kDegree * row.at("hand_ry"), Eigen::Vector3d::UnitY()) *
                                    Turn(kDegree * row.at("hand_rx"), Eigen::Vector3d::UnitX());
    pose.world_from_hand.translation =
        y_down({row.at("hand_tx"), row.at("hand_ty"), row.at("hand_tz")});
    for (int angle = 0; angle < kAngleCount; ++angle) {
      pose.angles[angle] =
          kDegree * row.at(std::string(angle_names()[static_cast<std::size_t>(angle)]));
    }
    const auto keypoints = posed_keypoints(skeleton, pose);
    for (std::size_t k = 0; k < keypoints.size(); ++k) {
      points[std::string(keypoint_names()[k])] = keypoints[k];
    }
  }
  return frames;
}

/// A BVH's joints, and its end sites by the name of their digit's tip, in every frame.
inline std::vector<NamedPoints> bvh_keypoints(const std::string& text) {
  struct Joint {
    std::string name;
    int parent = -1;
    Eigen::Vector3d offset;
    std::vector<std::string> channels;
  };
  std::istringstream stream(text);
  std::vector<Joint> joints;
  std::vector<int> open;
  std::string word;
  while (stream >> word && word != "MOTION") {
    if (word == "ROOT" || word == "JOINT" || word == "End") {
      Joint& joint = joints.emplace_back();
      joint.parent = open.empty() ? -1 : open.back();
      stream >> joint.name;
      if (word == "End") {
        const std::string& above = joints[static_cast<std::size_t>(joint.parent)].name;
        joint.name = above.substr(0, above.find('_')) + "_tip";
      }
    } else if (word == "{") {
      open.push_back(static_cast<int>(joints.size()) - 1);
    } else if (word == "}") {
      open.pop_back();
    } else if (word == "OFFSET") {
      stream >> joints.back().offset.x() >> joints.back().offset.y() >> joints.back().offset.z();
    } else if (word == "CHANNELS") {
      std::size_t count = 0;
      stream >> count;
      joints.back().channels.resize(count);
      for (std::string& channel : joints.back().channels) stream >> channel;
    }
  }
  std::size_t frame_count = 0;
  double interval = 0.0;
  stream >> word >> frame_count >> word >> word >> interval;
  std::vector<NamedPoints> frames(frame_count);
  for (NamedPoints& points : frames) {
    std::vector<Eigen::Affine3d> world;
    for (const Joint& joint : joints) {
      Eigen::Affine3d local(Eigen::Translation3d(joint.offset));
      for (const std::string& channel : joint.channels) {
        double number = std::nan("");
        stream >> number;
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(channel[0] - 'X');
        if (channel.ends_with("position")) {
          local = local * Eigen::Translation3d(number * axis);
        } else {
          local = local * Eigen::AngleAxisd(number * kDegree, axis);
        }
      }
      world.push_back(joint.parent < 0 ? local
                                       : world[static_cast<std::size_t>(joint.parent)] * local);
      points[joint.name] = 0.01 * y_down(world.back().translation());
    }
  }
  EXPECT_FALSE(stream.fail()) << "a frame has too few numbers";
  EXPECT_FALSE(stream >> word) << "there is more after the last frame";
  return frames;
}

/// A URDF's joint: parent, child, place and axis.
struct UrdfJoint {
  std::string name, type, parent, child;
  Eigen::Vector3d place, axis;
  double lower = 0.0, upper = 0.0;
};

inline std::vector<UrdfJoint> urdf_joints(const std::string& urdf) {
  const auto attribute = [](const std::string& block, const std::string& pattern) {
    std::smatch match;
    return std::regex_search(block, match, std::regex(pattern)) ? match[1].str() : std::string();
  };
  std::vector<UrdfJoint> joints;
  for (std::size_t at = urdf.find("<joint "); at != std::string::npos;
       at = urdf.find("<joint ", at + 1)) {
    const std::string block = urdf.substr(at, urdf.find("</joint>", at) - at);
    UrdfJoint& joint = joints.emplace_back();
    joint.name = attribute(block, "joint name=\"([^\"]*)\"");
    joint.type = attribute(block, "type=\"([^\"]*)\"");
    joint.parent = attribute(block, "parent link=\"([^\"]*)\"");
    joint.child = attribute(block, "child link=\"([^\"]*)\"");
    EXPECT_EQ(attribute(block, "rpy=\"([^\"]*)\""), "0 0 0");
    joint.place = numbers3(attribute(block, "origin xyz=\"([^\"]*)\""));
    if (joint.type == "fixed") continue;
    joint.axis = numbers3(attribute(block, "axis xyz=\"([^\"]*)\""));
    joint.lower = std::stod(attribute(block, "lower=\"([^\"]*)\""));
    joint.upper = std::stod(attribute(block, "upper=\"([^\"]*)\""));
  }
  return joints;
}

/// The links of a URDF that are called like keypoints, moved by its joint_states.csv.
inline std::vector<NamedPoints> urdf_keypoints(const std::string& urdf, const std::string& states) {
  const std::vector<UrdfJoint> joints = urdf_joints(urdf);
  std::vector<NamedPoints> frames;
  for (const auto& row : csv_rows(states)) {
    NamedPoints& points = frames.emplace_back();
    if (row.at("wrist_x_m").empty()) continue;
    const auto number = [&row](const std::string& key) { return std::stod(row.at(key)); };
    std::map<std::string, Eigen::Affine3d> links;
    links["wrist"] =
        Eigen::Translation3d(number("wrist_x_m"), number("wrist_y_m"), number("wrist_z_m")) *
        Eigen::Quaterniond(number("wrist_qw"), number("wrist_qx"), number("wrist_qy"),
                           number("wrist_qz"));
    for (const UrdfJoint& joint : joints) {  // parents come first
      Eigen::Affine3d local(Eigen::Translation3d(joint.place));
      if (joint.type == "revolute") {
        local = local * Eigen::AngleAxisd(number(joint.name), joint.axis);
      }
      links[joint.child] = links.at(joint.parent) * local;
    }
    // A joint of one angle has no link of its own between its bones: it is where the outer bone is.
    links["thumb_mcp"] = links.at("thumb_proximal");
    links["thumb_ip"] = links.at("thumb_distal");
    for (const std::string digit : {"index", "middle", "ring", "little"}) {
      links[digit + "_pip"] = links.at(digit + "_middle");
      links[digit + "_dip"] = links.at(digit + "_distal");
    }
    for (const std::string_view name : keypoint_names()) {
      points[std::string(name)] = links.at(std::string(name)).translation();
    }
  }
  return frames;
}

}  // namespace tegata
