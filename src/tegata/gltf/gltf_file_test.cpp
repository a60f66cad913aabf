// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/gltf_file.h"

#include "tegata/gltf/gltf_for_tests.h"

namespace tegata {
namespace {

class GltfFile : public SmallGltfHand {
 protected:
  static HandModel parse(const std::string& bytes) {
    return parse_hand_gltf(bytes, Side::right, "input.glb");
  }
  /// Whether bytes are read; if not, expects one line of error.
  static bool is_read(const std::string& bytes) {
    try {
      parse(bytes);
      return true;
    } catch (const Error&) {
      expect_refused([&] { parse(bytes); }, "input.glb: ");
      return false;
    }
  }
  /// The hand as glTF without spaces.
  std::string written_as_json() const {
    write_hand_gltf(hand_, {}, folder_ / "hand.gltf");
    std::ifstream stream(folder_ / "hand.gltf");
    std::string json{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    json.erase(
        std::remove_if(json.begin(), json.end(), [](char c) { return c == ' ' || c == '\n'; }),
        json.end());
    return json;
  }
};

TEST_F(GltfFile, BytesInMemoryAreTheHandOfTheFile) {
  const HandModel parsed = parse(glb_);
  EXPECT_EQ(parsed.name, "input");
  EXPECT_EQ(parsed.rest_surface.vertices.size(), hand_.rest_surface.vertices.size());
}

TEST_F(GltfFile, CutOffAtAnyByteIsOneError) {
  for (std::size_t length = 0; length < glb_.size(); ++length) {
    expect_refused([&] { parse(glb_.substr(0, length)); }, "input.glb: it ");
  }
}

TEST_F(GltfFile, CutOffJsonIsOneError) {
  const std::string json = written_as_json();
  ASSERT_NO_THROW(parse(json));
  for (std::size_t length = 0; length + 2 < json.size(); length += 61) {
    expect_refused([&] { parse(json.substr(0, length)); }, "input.glb: it is not glTF 2.0");
  }
}

TEST_F(GltfFile, LengthsThatAreTooLargeAreRefused) {
  for (const std::size_t place : {8U, 12U}) {
    std::string bytes = glb_;
    bytes[place + 3] = '\x7f';  // 2 GB
    expect_refused([&] { parse(bytes); }, "input.glb: it");
  }
}

// 2 GB in the words of the JSON: what it says and not what there is.
TEST_F(GltfFile, TwoGigabytesThatAreNotThereAreRefused) {
  const std::string json = written_as_json();
  int read_count = 0;
  for (const std::string key : {"\"count\":", "\"byteLength\":"}) {
    for (std::size_t at = json.find(key); at != std::string::npos; at = json.find(key, at + 1)) {
      std::string changed = json;
      const std::size_t number = at + key.size();
      changed.replace(number, changed.find_first_of(",}", number) - number, "2147483647");
      if (is_read(changed)) ++read_count;
    }
  }
  EXPECT_EQ(read_count, 2) << "only the normals, of which nothing is read";
}

TEST_F(GltfFile, BracketsWithoutEndAreRefusedAndNotFollowed) {
  const std::string deep(1'000'000, '[');
  expect_refused([&] { parse("{\"extras\":" + deep); }, "nested");
  expect_refused([&] { parse("{\"extras\":\"" + deep + "\"}"); }, "asset");  // only a string
}

TEST_F(GltfFile, OtherFilesAreNotOpenedForBytesInMemory) {
  expect_refused(
      [&] {
        parse(R"({"asset":{"version":"2.0"},"buffers":[{"uri":"/dev/zero","byteLength":4}]})");
      },
      "input.glb");
}

TEST_F(GltfFile, ABufferOfNoBytesIsRefused) {
  model_.buffers[0].data.clear();
  expect_refused([&] { read(); }, "changed.glb");
}

TEST_F(GltfFile, ExtensionsThatChangeTheVerticesAreRefused) {
  model_.extensionsUsed = model_.extensionsRequired = {"KHR_draco_mesh_compression"};
  expect_refused([&] { read(); }, "changed.glb", "KHR_draco_mesh_compression");
  model_.extensionsUsed = model_.extensionsRequired = {"KHR_materials_unlit"};
  EXPECT_NO_THROW(read());
}

}  // namespace
}  // namespace tegata
