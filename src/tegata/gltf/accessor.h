// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace tegata {

/// The numbers of an accessor, sparse or not, element after element; normalised integers become 0
/// .. 1 (or -1 .. 1). `components` is how many an element must have, `what` what it is called in
/// the Error that is thrown where the accessor is absent, of another kind or reaches out of its
/// buffer.
std::vector<double> read_accessor(const tinygltf::Model& model, int accessor, int components,
                                  const std::string& what);

/// Appends to the model's only buffer; each returns the index of the new accessor. Numbers have
/// `components` an element; `with_bounds` states the least and greatest, as positions and times
/// must. What uses it (vertices, indices, anything else) is `target` in glTF's numbers, or 0.
int append_floats(tinygltf::Model& model, const std::vector<float>& numbers, int components,
                  int target, bool with_bounds);
int append_indices(tinygltf::Model& model, const std::vector<std::uint32_t>& indices);
/// Elements of four bytes.
int append_byte_quads(tinygltf::Model& model, const std::vector<std::uint8_t>& bytes);

}  // namespace tegata
