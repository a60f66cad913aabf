// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/npz_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "tegata/base/error.h"

namespace tegata {
namespace {

template <typename Number>
void append(std::string& bytes, Number number) {
  static_assert(std::endian::native == std::endian::little);
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  bytes.append(raw.data(), raw.size());
}

template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes;
  bytes.reserve(sizeof(Number) * numbers.size());
  for (const Number number : numbers) append(bytes, number);
  return bytes;
}

/// The checksum of zip files (ISO 3309, polynomial 0x04C11DB7 reflected).
std::uint32_t crc32(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> made = {};
    for (std::uint32_t i = 0; i < made.size(); ++i) {
      std::uint32_t rest = i;
      for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1U ? 0xEDB88320U : 0U);
      made[i] = rest;
    }
    return made;
  }();
  std::uint32_t sum = ~0U;
  for (const char c : bytes) sum = sum >> 8 ^ table[(sum ^ static_cast<std::uint8_t>(c)) & 0xFFU];
  return ~sum;
}

/// The code points of a text in UTF-8; U+FFFD for each byte that does not belong to one.
std::vector<std::uint32_t> code_points(std::string_view text) {
  constexpr std::uint32_t kReplacement = 0xFFFD;
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<std::uint8_t>(text[i++]);
    const int length = lead < 0x80            ? 1
                       : lead >> 5 == 0b110   ? 2
                       : lead >> 4 == 0b1110  ? 3
                       : lead >> 3 == 0b11110 ? 4
                                              : 0;
    if (length < 2) {
      points.push_back(length == 1 ? lead : kReplacement);
      continue;
    }
    std::uint32_t point = lead & (0x7FU >> length);
    std::size_t at = i;
    for (int more = 1; more < length && at < text.size(); ++more, ++at) {
      const auto next = static_cast<std::uint8_t>(text[at]);
      if (next >> 6 != 0b10) break;
      point = point << 6 | (next & 0x3FU);
    }
    const bool is_whole = at - i + 1 == static_cast<std::size_t>(length) && point <= 0x10FFFF;
    points.push_back(is_whole ? point : kReplacement);
    if (is_whole) i = at;
  }
  return points;
}

void check_size(std::size_t size) {
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("NPZ: got ", size, " bytes, expected at most 4 GB; export fewer frames");
  }
}

/// What the records before an entry and in the directory have in common.
std::string entry_fields(const std::string& name, std::string_view content) {
  constexpr std::uint16_t kVersion = 20, kFlags = 0, kStored = 0, kTime = 0;
  constexpr std::uint16_t kFirstOf1980 = 1 << 5 | 1;  // so that the same arrays give the same bytes
  std::string fields;
  for (const std::uint16_t field : {kVersion, kFlags, kStored, kTime, kFirstOf1980}) {
    append(fields, field);
  }
  append(fields, crc32(content));
  append(fields, static_cast<std::uint32_t>(content.size()));  // compressed
  append(fields, static_cast<std::uint32_t>(content.size()));
  append(fields, static_cast<std::uint16_t>(name.size()));
  append(fields, std::uint16_t{0});  // extra field
  return fields;
}

}  // namespace

void NpzFile::add(std::string_view name, const Shape& shape, const std::vector<double>& numbers) {
  add_array(name, "<f8", shape, bytes_of(numbers));
}

void NpzFile::add(std::string_view name, const Shape& shape, const std::vector<float>& numbers) {
  add_array(name, "<f4", shape, bytes_of(numbers));
}

void NpzFile::add(std::string_view name, const Shape& shape,
                  const std::vector<std::int32_t>& numbers) {
  add_array(name, "<i4", shape, bytes_of(numbers));
}

void NpzFile::add(std::string_view name, const Shape& shape, const std::vector<bool>& flags) {
  add_array(name, "|b1", shape, std::string(flags.begin(), flags.end()));
}

void NpzFile::add(std::string_view name, const std::vector<std::string>& texts) {
  std::vector<std::vector<std::uint32_t>> lines;
  std::size_t width = 1;
  for (const std::string& text : texts) {
    lines.push_back(code_points(text));
    width = std::max(width, lines.back().size());
  }
  std::string content;
  for (std::vector<std::uint32_t>& line : lines) {
    line.resize(width, 0);
    content += bytes_of(line);
  }
  add_array(name, text("<U", width), {texts.size()}, content);
}

void NpzFile::add_array(std::string_view name, std::string_view type, const Shape& shape,
                        std::string_view content) {
  constexpr std::size_t kAlignment = 64, kPreamble = 10;
  std::size_t count = 1;
  std::string extents;
  for (const std::size_t extent : shape) {
    count *= extent;
    extents += text(extent, ", ");
  }
  const std::size_t width = type.starts_with("<U") ? 4 * std::stoul(std::string(type.substr(2)))
                                                   : static_cast<std::size_t>(type.back() - '0');
  if (content.size() != count * width) {
    throw Error("NPZ array '", name, "': got ", content.size() / width, " elements, expected ",
                count);
  }
  std::string header =
      text("{'descr': '", type, "', 'fortran_order': False, 'shape': (", extents, "), }");
  const std::size_t unpadded = kPreamble + header.size() + 1;
  header.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
  header += '\n';
  std::string array("\x93NUMPY\x01\x00", 8);
  append(array, static_cast<std::uint16_t>(header.size()));
  entries_.push_back({std::string(name) + ".npy", array + header + std::string(content)});
}

std::string NpzFile::bytes() const {
  std::string file, directory;
  for (const Entry& entry : entries_) {
    const std::size_t begin = file.size();
    check_size(begin + entry.content.size());
    const std::string fields = entry_fields(entry.name, entry.content);
    file += "PK\x03\x04" + fields + entry.name + entry.content;
    directory += std::string("PK\x01\x02\x14\x00", 6) + fields;
    directory.append(10, '\0');  // comment, disk and attributes: none
    append(directory, static_cast<std::uint32_t>(begin));
    directory += entry.name;
  }
  const std::size_t begin = file.size();
  check_size(begin + directory.size());
  file += directory + "PK\x05\x06" + std::string(4, '\0');  // disks: this one
  for (int i = 0; i < 2; ++i) append(file, static_cast<std::uint16_t>(entries_.size()));
  append(file, static_cast<std::uint32_t>(directory.size()));
  append(file, static_cast<std::uint32_t>(begin));
  append(file, std::uint16_t{0});  // comment
  return file;
}

}  // namespace tegata
