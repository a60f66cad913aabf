// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A GLB as a viewer has it at a time of its animation, read from the bytes by the specification of
// glTF 2.0 and with nothing of the room that writes them.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tegata {

class Glb {
 public:
  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2U);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const std::size_t length = word(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json_ = nlohmann::json::parse(bytes.substr(20, length));
    const std::size_t binary = 20 + length;
    EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
    binary_ = bytes.substr(binary + 8, word(bytes, binary));
    const auto& nodes = json_.at("nodes");
    parents_.assign(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const auto& child : nodes[i].value("children", nlohmann::json::array())) {
        parents_.at(child.get<std::size_t>()) = static_cast<int>(i);
      }
    }
  }

  const nlohmann::json& json() const { return json_; }

  /// The names of the skin's joints.
  std::vector<std::string> joint_names() const {
    std::vector<std::string> names;
    for (const auto& joint : json_.at("skins")[0].at("joints")) {
      names.push_back(json_.at("nodes")[joint.get<std::size_t>()].at("name"));
    }
    return names;
  }

  /// A node's transform to the world (y up, metres) at a time of the first animation.
  Eigen::Affine3d world(const std::string& name, double time) const {
    const auto& nodes = json_.at("nodes");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].value("name", "") == name) return world(static_cast<int>(i), time);
    }
    ADD_FAILURE() << "there is no node " << name;
    return Eigen::Affine3d::Identity();
  }

 private:
  static std::size_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof(number));
    return number;
  }

  /// An accessor of floats, element after element.
  std::vector<double> numbers(std::size_t accessor) const {
    const auto& described = json_.at("accessors")[accessor];
    EXPECT_EQ(described.at("componentType"), 5126);
    const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    const std::size_t count =
        described.at("count").get<std::size_t>() * widths.at(described.at("type"));
    const auto& view = json_.at("bufferViews")[described.at("bufferView").get<std::size_t>()];
    EXPECT_FALSE(view.contains("byteStride"));
    const std::size_t begin =
        view.value("byteOffset", std::size_t{0}) + described.value("byteOffset", std::size_t{0});
    std::vector<float> stored(count);
    std::memcpy(stored.data(), binary_.data() + begin, 4 * count);
    return {stored.begin(), stored.end()};
  }

  /// What the animation has for a node's property at a time, or what the node has, or `none`.
  std::vector<double> property(int node, const std::string& path, double time,
                               const std::vector<double>& none) const {
    for (const auto& channel : json_.at("animations")[0].at("channels")) {
      const auto& target = channel.at("target");
      if (target.at("node") != node || target.at("path") != path) continue;
      const auto& sampler =
          json_.at("animations")[0].at("samplers")[channel.at("sampler").get<std::size_t>()];
      return sampled(numbers(sampler.at("input")), numbers(sampler.at("output")),
                     sampler.value("interpolation", "LINEAR"), time);
    }
    return json_.at("nodes")[static_cast<std::size_t>(node)].value(path, none);
  }

  /// Between keyframes quaternions are mixed and normalised, which is near enough for a test.
  static std::vector<double> sampled(const std::vector<double>& times,
                                     const std::vector<double>& outputs,
                                     const std::string& interpolation, double time) {
    const std::size_t width = outputs.size() / times.size();
    std::size_t at = 0;
    while (at + 1 < times.size() && times[at + 1] <= time + 1e-6) ++at;
    double part = 0.0;
    if (interpolation == "LINEAR" && at + 1 < times.size() && time > times[at]) {
      part = (time - times[at]) / (times[at + 1] - times[at]);
    }
    std::vector<double> mixed(width);
    const std::size_t next = std::min(at + 1, times.size() - 1);
    for (std::size_t i = 0; i < width; ++i) {
      mixed[i] = (1.0 - part) * outputs[at * width + i] + part * outputs[next * width + i];
    }
    return mixed;
  }

  Eigen::Affine3d world(int node, double time) const {
    const std::vector<double> place = property(node, "translation", time, {0.0, 0.0, 0.0});
    const std::vector<double> turn = property(node, "rotation", time, {0.0, 0.0, 0.0, 1.0});
    const std::vector<double> scale = property(node, "scale", time, {1.0, 1.0, 1.0});
    Eigen::Affine3d local(Eigen::Translation3d(place[0], place[1], place[2]));
    local.rotate(Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]).normalized());
    local.scale(Eigen::Vector3d(scale[0], scale[1], scale[2]));
    const int parent = parents_[static_cast<std::size_t>(node)];
    return parent < 0 ? local : world(parent, time) * local;
  }

  nlohmann::json json_;
  std::string binary_;
  std::vector<int> parents_;
};

}  // namespace tegata
