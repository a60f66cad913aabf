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
#include "tegata/take/staged_folder.h"

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

void make_seeds(const std::filesystem::path& folder) {
  const HandModel hand = test_hand();
  const std::filesystem::path glb = seeds_of(folder, "glb");
  write_hand_gltf(hand, {}, glb / "right.glb");
  write_hand_gltf(mirrored(hand), {HandKeyframe{}}, glb / "left.glb");
  write_parts(read_file(glb / "right.glb"), glb / "right.parts");
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
