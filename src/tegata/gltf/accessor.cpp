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

// So many elements of a hand would take a GB of memory in doubles.
constexpr std::size_t kMostElements = std::size_t{1} << 23;

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

/// Where numbers begin.
struct Place {
  int view = -1;
  std::size_t offset = 0;  // [bytes]
};

struct Elements {
  int component_type = 0;
  int components = 0;  // an element
  bool normalized = false;
  std::size_t count = 0;
};

std::vector<double> read_elements(const tinygltf::Model& model, const Place& place,
                                  const Elements& elements, const std::string& what) {
  const auto size = static_cast<std::ptrdiff_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(elements.component_type)));
  if (size <= 0 || elements.component_type == TINYGLTF_COMPONENT_TYPE_DOUBLE) {
    throw Error(what, ": unknown component type ", elements.component_type);
  }
  if (place.view < 0 || static_cast<std::size_t>(place.view) >= model.bufferViews.size()) {
    throw Error(what, ": buffer view ", place.view, " is not among the file's ",
                model.bufferViews.size());
  }
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(place.view)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
    throw Error(what, ": buffer ", view.buffer, " is not among the file's ", model.buffers.size());
  }
  const std::vector<unsigned char>& bytes =
      model.buffers[static_cast<std::size_t>(view.buffer)].data;
  const auto width = static_cast<std::size_t>(size);
  const std::size_t element = width * static_cast<std::size_t>(elements.components);
  const std::size_t stride = view.byteStride == 0 ? element : view.byteStride;
  const std::size_t available = bytes.size();
  // Each step is checked before it is added, as any of these may be as large as a file says.
  bool fits = view.byteOffset <= available && view.byteLength <= available - view.byteOffset &&
              place.offset <= view.byteLength;
  if (fits && elements.count > 0) {
    const std::size_t room = view.byteLength - place.offset;
    fits = element <= room && (elements.count - 1) <= (room - element) / stride;
  }
  if (!fits) throw Error(what, ": ", elements.count, " elements reach out of their buffer");

  std::vector<double> numbers;
  numbers.reserve(elements.count * static_cast<std::size_t>(elements.components));
  const unsigned char* start = bytes.data() + view.byteOffset + place.offset;
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(elements.components); ++c) {
      numbers.push_back(
          component(start + i * stride + c * width, elements.component_type, elements.normalized));
    }
  }
  return numbers;
}

std::size_t offset_of(int offset, const std::string& what) {
  if (offset < 0) throw Error(what, ": a sparse part begins at byte ", offset);
  return static_cast<std::size_t>(offset);
}

/// Replaces the few elements that a sparse accessor lists.
void replace_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                    const Elements& elements, const std::string& what,
                    std::vector<double>& numbers) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > elements.count) {
    throw Error(what, ": ", sparse.count, " sparse elements of ", elements.count);
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::vector<double> places =
      read_elements(model, {sparse.indices.bufferView, offset_of(sparse.indices.byteOffset, what)},
                    {sparse.indices.componentType, 1, false, count}, what + ", sparse indices");
  Elements replaced = elements;
  replaced.count = count;
  const std::vector<double> values =
      read_elements(model, {sparse.values.bufferView, offset_of(sparse.values.byteOffset, what)},
                    replaced, what + ", sparse values");
  const auto width = static_cast<std::size_t>(elements.components);
  for (std::size_t i = 0; i < count; ++i) {
    if (!(places[i] >= 0.0 && places[i] < static_cast<double>(elements.count))) {
      throw Error(what, ": sparse index ", places[i], " of ", elements.count, " elements");
    }
    const std::size_t to = width * static_cast<std::size_t>(places[i]);
    std::copy_n(&values[width * i], width, &numbers[to]);
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
  if (accessor.count > kMostElements) {
    throw Error(what, ": ", accessor.count, " elements, expected ", kMostElements, " at most");
  }
  const Elements elements{accessor.componentType, components, accessor.normalized, accessor.count};
  std::vector<double> numbers(accessor.count * static_cast<std::size_t>(components), 0.0);
  if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
    const Place place{accessor.bufferView, accessor.byteOffset};
    numbers = read_elements(model, place, elements, what);
  }
  if (accessor.sparse.isSparse) replace_sparse(model, accessor, elements, what, numbers);
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
