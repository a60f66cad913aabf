// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Greg Turk, The PLY Polygon File Format (1994).
#include "tegata/mesh/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/mesh/words.h"

namespace tegata {
namespace {

static_assert(std::endian::native == std::endian::little, "binary PLY is read as it lies");

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::array<std::pair<std::string_view, Scalar>, 16> kScalarNames = {{
    {"char", Scalar::int8},
    {"int8", Scalar::int8},
    {"uchar", Scalar::uint8},
    {"uint8", Scalar::uint8},
    {"short", Scalar::int16},
    {"int16", Scalar::int16},
    {"ushort", Scalar::uint16},
    {"uint16", Scalar::uint16},
    {"int", Scalar::int32},
    {"int32", Scalar::int32},
    {"uint", Scalar::uint32},
    {"uint32", Scalar::uint32},
    {"float", Scalar::float32},
    {"float32", Scalar::float32},
    {"double", Scalar::float64},
    {"float64", Scalar::float64},
}};

struct Property {
  std::string name;
  Scalar type = Scalar::float32;
  std::optional<Scalar> count_type;  // lists only
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& file) : file_(file), rest_(bytes) {}

  TriangleMesh read() {
    read_header();
    bool has_vertices = false;
    for (const Element& element : elements_) {
      check_length(element);
      if (element.name == "vertex") {
        read_vertices(element);
        has_vertices = true;
      } else {
        read_faces_or_skip(element);
      }
    }
    if (!has_vertices) throw Error(file_, ": no element 'vertex', expected one");
    try {
      check_mesh(mesh_);
    } catch (const Error& error) {
      throw Error(file_, ": ", error.what());
    }
    return std::move(mesh_);
  }

 private:
  Scalar scalar_type(std::string_view name) const {
    for (const auto& [known, type] : kScalarNames) {
      if (known == name) return type;
    }
    throw Error(file_, ": property type '", name, "', expected char to double or int8 to float64");
  }

  void read_header() {
    std::string_view line = take_line(rest_);
    if (take_word(line) != "ply") throw Error(file_, ": does not begin with 'ply'");
    bool has_format = false;
    while (!rest_.empty()) {
      line = take_line(rest_);
      const std::string_view key = take_word(line);
      if (key == "end_header") {
        if (!has_format) throw Error(file_, ": no format line in the header");
        return;
      }
      if (key == "format") {
        const std::string_view format = take_word(line);
        has_format = true;
        is_ascii_ = format == "ascii";
        if (!is_ascii_ && format != "binary_little_endian") {
          throw Error(file_, ": format '", format, "', expected ascii or binary_little_endian");
        }
      } else if (key == "element") {
        const std::string name(take_word(line));
        const auto count = parse<std::size_t>(take_word(line));
        if (!count) throw Error(file_, ": element '", name, "' has no count");
        elements_.push_back({.name = name, .count = *count, .properties = {}});
      } else if (key == "property") {
        if (elements_.empty()) throw Error(file_, ": a property before the first element");
        elements_.back().properties.push_back(read_property(line));
      } else if (key != "comment" && key != "obj_info" && !key.empty()) {
        throw Error(file_, ": header line '", key.substr(0, 40),
                    "', expected format, element, property, comment or end_header");
      }
    }
    throw Error(file_, ": no end_header");
  }

  Property read_property(std::string_view line) const {
    Property property;
    std::string_view word = take_word(line);
    if (word == "list") {
      property.count_type = scalar_type(take_word(line));
      word = take_word(line);
    }
    property.type = scalar_type(word);
    property.name = take_word(line);
    return property;
  }

  static std::size_t size_of(Scalar type) {
    constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
  }

  // A wrong count must not make us ask for more memory than the file could fill.
  void check_length(const Element& element) const {
    std::size_t least = 0;
    for (const Property& p : element.properties) {
      least += is_ascii_ ? 2 : size_of(p.count_type.value_or(p.type));
    }
    if (least > 0 && element.count > (rest_.size() + 1) / least) fail_truncated(element);
  }

  [[noreturn]] void fail_truncated(const Element& element) const {
    throw Error(file_, ": ends before its ", element.count, " elements '", element.name,
                "' do: truncated?");
  }

  template <typename T>
  double take_binary() {
    T value;
    std::memcpy(&value, rest_.data(), sizeof(T));
    rest_.remove_prefix(sizeof(T));
    return static_cast<double>(value);
  }

  double take_number(Scalar type, const Element& element) {
    if (is_ascii_) {
      const std::string_view word = take_word(rest_);
      if (word.empty()) fail_truncated(element);
      const auto number = parse<double>(word);
      if (!number) {
        throw Error(file_, ": '", word.substr(0, 40), "' in element '", element.name,
                    "', expected a number");
      }
      return *number;
    }
    if (rest_.size() < size_of(type)) fail_truncated(element);
    switch (type) {
      case Scalar::int8:
        return take_binary<std::int8_t>();
      case Scalar::uint8:
        return take_binary<std::uint8_t>();
      case Scalar::int16:
        return take_binary<std::int16_t>();
      case Scalar::uint16:
        return take_binary<std::uint16_t>();
      case Scalar::int32:
        return take_binary<std::int32_t>();
      case Scalar::uint32:
        return take_binary<std::uint32_t>();
      case Scalar::float32:
        return take_binary<float>();
      case Scalar::float64:
        break;
    }
    return take_binary<double>();
  }

  // A whole number from 0 to 2^32 - 1, as list lengths and vertex indices are.
  std::uint32_t take_index(Scalar type, const Element& element, std::size_t row) {
    const double number = take_number(type, element);
    if (!(number >= 0.0 && number < 4294967296.0) || number != std::floor(number)) {
      throw Error(file_, ": ", element.name, " ", row, " has the count or index ", number,
                  ", expected a whole number from 0");
    }
    return static_cast<std::uint32_t>(number);
  }

  void skip_list(const Property& property, const Element& element, std::size_t row) {
    const std::uint32_t length = take_index(*property.count_type, element, row);
    for (std::uint32_t i = 0; i < length; ++i) take_number(property.type, element);
  }

  void read_vertices(const Element& element) {
    constexpr std::array<std::string_view, 7> kNames = {"x",  "y",  "z",       "nx",
                                                        "ny", "nz", "unproven"};
    std::vector<std::size_t> slots;  // of each property in `values`; the last one is for the rest
    std::array<bool, 8> present{};
    for (const Property& p : element.properties) {
      const auto slot = static_cast<std::size_t>(std::find(kNames.begin(), kNames.end(), p.name) -
                                                 kNames.begin());
      slots.push_back(p.count_type ? kNames.size() : slot);
      present[slots.back()] = true;
    }
    if (!present[0] || !present[1] || !present[2]) {
      throw Error(file_, ": vertices without x, y or z, expected all three");
    }
    const bool has_normals = present[3] && present[4] && present[5];
    std::array<double, 8> values{};
    for (std::size_t row = 0; row < element.count; ++row) {
      for (std::size_t i = 0; i < slots.size(); ++i) {
        const Property& p = element.properties[i];
        if (p.count_type) {
          skip_list(p, element, row);
        } else {
          values[slots[i]] = take_number(p.type, element);
        }
      }
      mesh_.vertices.emplace_back(values[0], values[1], values[2]);
      if (has_normals) mesh_.normals.emplace_back(values[3], values[4], values[5]);
      if (present[6]) mesh_.unproven.push_back(values[6] != 0.0 ? 1 : 0);
    }
  }

  void read_faces_or_skip(const Element& element) {
    if (element.properties.empty()) return;
    const bool is_face = element.name == "face";
    std::vector<std::uint32_t> face;
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const Property& p : element.properties) {
        if (!p.count_type) {
          take_number(p.type, element);
        } else if (!is_face || (p.name != "vertex_indices" && p.name != "vertex_index")) {
          skip_list(p, element, row);
        } else {
          face.clear();
          const std::uint32_t corner_count = take_index(*p.count_type, element, row);
          for (std::uint32_t i = 0; i < corner_count; ++i) {
            face.push_back(take_index(p.type, element, row));
          }
          if (face.size() < 3) {
            throw Error(file_, ": face ", row, " has ", face.size(),
                        " corners, expected 3 or more");
          }
          for (std::size_t i = 2; i < face.size(); ++i) {
            mesh_.triangles.push_back({face[0], face[i - 1], face[i]});
          }
        }
      }
    }
  }

  std::string file_;
  std::string_view rest_;
  bool is_ascii_ = false;
  std::vector<Element> elements_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh parse_ply(std::string_view bytes, const std::string& file) {
  return PlyReader(bytes, file).read();
}

}  // namespace tegata
