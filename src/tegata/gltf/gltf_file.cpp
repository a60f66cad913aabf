// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/gltf_file.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "tegata/base/error.h"

namespace tegata {
namespace {

// Of GLB: the file's header, then a chunk's length and kind.
constexpr std::size_t kLengthPlace = 8, kJsonLengthPlace = 12, kJsonPlace = 20;
constexpr int kDeepestNesting = 200;

std::string one_line(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && message.back() == ' ') message.pop_back();
  return message;
}

/// Pictures are left as they are: nothing of a hand is read from them.
bool skip_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                const unsigned char*, int, void*) {
  return true;
}

std::size_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, &bytes[place], sizeof number);
  return number;
}

/// The JSON of a GLB: its first chunk.
std::string_view json_of_glb(std::string_view bytes) {
  const std::size_t header = std::min(bytes.size(), kJsonPlace);
  const std::size_t whole = header < kJsonPlace ? kJsonPlace : number_at(bytes, kLengthPlace);
  if (bytes.size() < whole) {
    throw Error("it ends after ", bytes.size(), " bytes, expected ", whole,
                header < kJsonPlace ? " or more" : " as it says itself", ": is it cut off?");
  }
  const std::size_t length = number_at(bytes, kJsonLengthPlace);
  if (length > bytes.size() - kJsonPlace) {
    throw Error("its JSON has ", length, " bytes, but only ", bytes.size() - kJsonPlace, " follow");
  }
  return bytes.substr(kJsonPlace, length);
}

/// Lists within lists are read by functions that call themselves, so that a file of brackets alone
/// would use up the stack.
void check_nesting(std::string_view json) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepestNesting) {
        throw Error("its JSON is nested more than ", kDeepestNesting, " deep");
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

/// What the required extensions of a file must be for it to be read right without knowing them.
bool is_harmless(std::string_view extension) {
  constexpr std::array<std::string_view, 6> kHarmless = {
      "KHR_texture_transform", "KHR_texture_basisu",  "EXT_texture_webp",
      "EXT_texture_avif",      "KHR_lights_punctual", "KHR_mesh_quantization"};
  return extension.starts_with("KHR_materials_") ||
         std::find(kHarmless.begin(), kHarmless.end(), extension) != kHarmless.end();
}

void load(std::string_view bytes, bool is_binary, tinygltf::TinyGLTF& loader,
          const std::string& folder, tinygltf::Model& model) {
  std::string problem, warning;
  const auto size = static_cast<unsigned int>(bytes.size());
  bool is_loaded = false;
  try {
    is_loaded =
        is_binary
            ? loader.LoadBinaryFromMemory(&model, &problem, &warning,
                                          reinterpret_cast<const unsigned char*>(bytes.data()),
                                          size, folder)
            : loader.LoadASCIIFromString(&model, &problem, &warning, bytes.data(), size, folder);
  } catch (const std::out_of_range&) {
    problem = "a buffer of no bytes";
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!is_loaded) throw Error("it is not glTF 2.0: ", one_line(problem));
}

}  // namespace

tinygltf::Model load_gltf(std::string_view bytes,
                          const std::optional<std::filesystem::path>& folder) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("it has ", bytes.size(), " bytes, expected less than 4 GB");
  }
  const bool is_binary = bytes.starts_with("glTF");
  check_nesting(is_binary ? json_of_glb(bytes) : bytes);
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(&skip_image, nullptr);
  if (!folder) loader.SetFsCallbacks({});
  tinygltf::Model model;
  load(bytes, is_binary, loader, folder ? folder->string() : std::string(), model);
  for (const std::string& extension : model.extensionsRequired) {
    if (!is_harmless(extension)) {
      throw Error("it needs the extension ", extension, ", which is not read");
    }
  }
  return model;
}

}  // namespace tegata
