// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <tiny_gltf.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tegata/base/error.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/test_hand.h"

namespace tegata {

/// A small hand in a glTF file that a test can spoil: nodes 1 to 25 are the joints in WebXR's
/// order.
class SmallGltfHand : public testing::Test {
 protected:
  SmallGltfHand()
      : folder_(std::filesystem::temp_directory_path() /
                ("tegata_small_hand_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    hand_ = test_hand();
    write_hand_gltf(hand_, {}, folder_ / "hand.glb");
    std::ifstream stream(folder_ / "hand.glb", std::ios::binary);
    glb_.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    tinygltf::TinyGLTF loader;
    std::string problem, warning;
    EXPECT_TRUE(
        loader.LoadBinaryFromFile(&model_, &problem, &warning, (folder_ / "hand.glb").string()))
        << problem;
  }
  ~SmallGltfHand() override { std::filesystem::remove_all(folder_); }

  tinygltf::Node& joint(int index) { return model_.nodes[static_cast<std::size_t>(1 + index)]; }
  tinygltf::Primitive& primitive() { return model_.meshes[0].primitives[0]; }

  /// Reads the model as a file of it would be; without the notes that write_hand_gltf leaves.
  HandModel read_plain(Side side = Side::right) {
    model_.asset.extras = tinygltf::Value();
    return read(side);
  }
  HandModel read(Side side = Side::right) {
    tinygltf::TinyGLTF writer;
    EXPECT_TRUE(writer.WriteGltfSceneToFile(&model_, (folder_ / "changed.glb").string(), true, true,
                                            false, true));
    return read_hand_gltf(folder_ / "changed.glb", side);
  }

  /// Expects one line that names the file and has each of the words in it.
  template <typename Read, typename... Words>
  static void expect_refused(const Read& read, const Words&... words) {
    try {
      read();
      ADD_FAILURE() << "it was read";
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      for (const std::string& word : {std::string(words)...}) {
        EXPECT_NE(message.find(word), std::string::npos) << message;
      }
    }
  }

  std::filesystem::path folder_;
  HandModel hand_;
  std::string glb_;
  tinygltf::Model model_;
};

}  // namespace tegata
