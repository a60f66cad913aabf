// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace tinygltf {
class Model;
}

namespace tegata {

/// The content of a GLB or glTF file; pictures are left out. `folder` is where other files that it
/// refers to lie; without one such a reference is an Error. Throws Error where the bytes are cut
/// off, are not glTF 2.0 or need an extension that changes what vertices are.
tinygltf::Model load_gltf(std::string_view bytes,
                          const std::optional<std::filesystem::path>& folder);

}  // namespace tegata
