// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a skinned hand. An input that begins with "glTF" is read as it is; another is taken
// as JSON, a zero byte and the binary chunk, and wrapped up, so that the fuzzer need not keep the
// lengths in a GLB's header right.
#include <cstring>
#include <string>
#include <string_view>

#include "bytes.h"
#include "tegata/base/error.h"
#include "tegata/gltf/hand_gltf.h"

namespace {

void append_chunk(std::string& glb, const char* kind, std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  const auto size = static_cast<std::uint32_t>(content.size());
  glb.append(reinterpret_cast<const char*>(&size), 4);
  glb.append(kind, 4);
  glb += content;
}

std::string wrapped(std::string_view parts) {
  const std::size_t end = parts.find('\0');
  std::string glb("glTF\2\0\0\0\0\0\0\0", 12);
  append_chunk(glb, "JSON", std::string(parts.substr(0, end)), ' ');
  if (end != std::string_view::npos) {
    append_chunk(glb, "BIN\0", std::string(parts.substr(end + 1)), '\0');
  }
  const auto size = static_cast<std::uint32_t>(glb.size());
  std::memcpy(&glb[8], &size, 4);
  return glb;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string glb = bytes.starts_with("glTF") ? std::string(bytes) : wrapped(bytes);
  const tegata::Side side = size % 2 == 0 ? tegata::Side::right : tegata::Side::left;
  try {
    tegata::check_hand(tegata::parse_hand_gltf(glb, side, "input"));
  } catch (const tegata::Error& error) {
    tegata::require(std::strchr(error.what(), '\n') == nullptr, "an error of several lines");
  }
  return 0;
}
