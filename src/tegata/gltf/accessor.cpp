// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/accessor.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "tegata/base/error.h"

namespace tegata {
namespace {

template <typename T>
double number_at(const unsigned char* bytes, bool normalized) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  const auto number = static_cast<double>(value);
  if constexpr (std::numeric_limits<T>::is_integer) {
    if (normalized) {
      return std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
    }
  }
  return number;
}

double component(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return number_at<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return number_at<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return number_at<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return number_at<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return number_at<std::uint32_t>(bytes, normalized);
    default:
      return number_at<float>(bytes, normalized);
  }
}

/// A type of glTF by its number of components, of vectors and 4 x 4 matrices.
int type_of(int components) {
  return components == 1    ? TINYGLTF_TYPE_SCALAR
         : components == 16 ? TINYGLTF_TYPE_MAT4
                            : components;  // VEC2, VEC3 and VEC4 are 2, 3 and 4
}

template <typename T>
int append(tinygltf::Model& model, const std::vector<T>& numbers, int components, int target,
           int component_type) {
  if (model.buffers.empty()) model.buffers.emplace_back();
  std::vector<unsigned char>& bytes = model.buffers[0].data;
  bytes.resize((bytes.size() + 3) / 4 * 4);

  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = numbers.size() * sizeof(T);
  view.target = target;
  bytes.resize(view.byteOffset + view.byteLength);
  if (!numbers.empty()) std::memcpy(&bytes[view.byteOffset], numbers.data(), view.byteLength);
  model.bufferViews.push_back(view);

  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size()) - 1;
  accessor.componentType = component_type;
  accessor.type = type_of(components);
  accessor.count = numbers.size() / static_cast<std::size_t>(components);
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

}  // namespace

std::vector<double> read_accessor(const tinygltf::Model& model, int index, int components,
                                  const std::string& what) {
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) {
    throw Error(what, ": accessor ", index, " is not among the file's ", model.accessors.size());
  }
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const auto kind = static_cast<std::uint32_t>(accessor.type);
  if (tinygltf::GetNumComponentsInType(kind) != components) {
    throw Error(what, ": elements of ", tinygltf::GetNumComponentsInType(kind),
                " numbers, expected ", components);
  }
  if (accessor.sparse.isSparse) throw Error(what, ": sparse accessors are not read");
  const auto size = static_cast<std::ptrdiff_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
  if (size <= 0 || accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE) {
    throw Error(what, ": unknown component type ", accessor.componentType);
  }
  if (accessor.bufferView < 0 ||
      static_cast<std::size_t>(accessor.bufferView) >= model.bufferViews.size()) {
    throw Error(what, ": buffer view ", accessor.bufferView, " is not among the file's ",
                model.bufferViews.size());
  }
  const tinygltf::BufferView& view =
      model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
    throw Error(what, ": buffer ", view.buffer, " is not among the file's ", model.buffers.size());
  }
  const std::vector<unsigned char>& bytes =
      model.buffers[static_cast<std::size_t>(view.buffer)].data;
  const auto element = static_cast<std::size_t>(size) * static_cast<std::size_t>(components);
  const std::size_t stride = view.byteStride == 0 ? element : view.byteStride;
  const std::size_t available = bytes.size();
  // Each step is checked before it is added, as any of these may be as large as a file says.
  bool fits = view.byteOffset <= available && view.byteLength <= available - view.byteOffset &&
              accessor.byteOffset <= view.byteLength;
  if (fits && accessor.count > 0) {
    const std::size_t room = view.byteLength - accessor.byteOffset;
    fits = element <= room && (accessor.count - 1) <= (room - element) / stride;
  }
  if (!fits) throw Error(what, ": ", accessor.count, " elements reach out of their buffer");

  std::vector<double> numbers;
  numbers.reserve(accessor.count * static_cast<std::size_t>(components));
  const unsigned char* start = bytes.data() + view.byteOffset + accessor.byteOffset;
  for (std::size_t i = 0; i < accessor.count; ++i) {
    for (int c = 0; c < components; ++c) {
      numbers.push_back(component(
          start + i * stride + static_cast<std::size_t>(c) * static_cast<std::size_t>(size),
          accessor.componentType, accessor.normalized));
    }
  }
  return numbers;
}

int append_floats(tinygltf::Model& model, const std::vector<float>& numbers, int components,
                  int target, bool with_bounds) {
  const int index = append(model, numbers, components, target, TINYGLTF_COMPONENT_TYPE_FLOAT);
  if (with_bounds) {
    tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const auto width = static_cast<std::size_t>(components);
    accessor.minValues.assign(width, std::numeric_limits<double>::infinity());
    accessor.maxValues.assign(width, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto number = static_cast<double>(numbers[i]);
      accessor.minValues[i % width] = std::min(accessor.minValues[i % width], number);
      accessor.maxValues[i % width] = std::max(accessor.maxValues[i % width], number);
    }
  }
  return index;
}

int append_indices(tinygltf::Model& model, const std::vector<std::uint32_t>& indices) {
  return append(model, indices, 1, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER,
                TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
}

int append_byte_quads(tinygltf::Model& model, const std::vector<std::uint8_t>& bytes) {
  return append(model, bytes, 4, TINYGLTF_TARGET_ARRAY_BUFFER,
                TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE);
}

}  // namespace tegata
