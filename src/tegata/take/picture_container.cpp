// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/picture_container.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kPngChunkFrame = 12;  // length, type and checksum, four bytes each

std::uint32_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

// `count` bytes as a number; throws where the file ends before.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count,
                        bool little_endian = false) {
  if (at > bytes.size() || bytes.size() - at < count) {
    throw Error("the file is cut short, expected more than its ", bytes.size(), " bytes");
  }
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    number = number << 8 | byte_at(bytes, at + (little_endian ? count - 1 - i : i));
  }
  return number;
}

// The checksum of PNG chunks (PNG specification, 5.5 and annex D).
std::uint32_t crc32(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table = {};
    for (std::uint32_t n = 0; n < table.size(); ++n) {
      std::uint32_t c = n;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1u) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      table[n] = c;
    }
    return table;
  }();
  std::uint32_t c = 0xffffffffu;
  for (const char byte : bytes) c = kTable[(c ^ static_cast<unsigned char>(byte)) & 0xffu] ^ c >> 8;
  return ~c;
}

// No camera has more pixels; a few damaged bytes may claim a thousand times as many.
void check_extent(std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kMostPixels = 1u << 26;
  if (width > 0 && height > kMostPixels / width) {
    throw Error("got a picture of ", width, " x ", height, " pixels, expected at most ",
                kMostPixels);
  }
}

// The chunk that starts at `at`, with its frame; checks that it lies within the file.
std::string_view png_chunk(std::string_view bytes, std::size_t at) {
  const std::size_t size = number_at(bytes, at, 4) + kPngChunkFrame;
  if (bytes.size() - at < size) {
    throw Error("the file is cut short, expected more than its ", bytes.size(), " bytes");
  }
  return bytes.substr(at, size);
}

void check_png(std::string_view bytes) {
  for (std::size_t at = kPngSignature.size();;) {
    const std::string_view chunk = png_chunk(bytes, at);
    const std::string_view type_and_content = chunk.substr(4, chunk.size() - 8);
    if (crc32(type_and_content) != number_at(chunk, chunk.size() - 4, 4)) {
      throw Error("the file is damaged: wrong checksum at byte ", at);
    }
    if (at == kPngSignature.size() &&
        !(type_and_content.starts_with("IHDR") && chunk.size() == 25)) {
      throw Error("the file is damaged: a PNG without a header");
    }
    if (at == kPngSignature.size()) check_extent(number_at(chunk, 8, 4), number_at(chunk, 12, 4));
    if (type_and_content.starts_with("IEND")) return;
    at += chunk.size();
  }
}

// Of any coding process: tables and a reserved marker lie between (ITU-T T.81, table B.1).
bool is_frame_header(std::uint32_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

// ITU-T T.81, annex B.
void check_jpeg(std::string_view bytes) {
  constexpr std::uint32_t kEnd = 0xd9, kScan = 0xda, kFirstAlone = 0xd0, kLastAlone = 0xd8;
  for (std::size_t at = 2;;) {
    if (number_at(bytes, at, 1) != 0xff) {
      throw Error("the file is damaged: no JPEG marker at byte ", at);
    }
    const std::uint32_t marker = number_at(bytes, at + 1, 1);
    if (marker == kEnd) return;
    if (marker == 0xff) {  // fill
      ++at;
      continue;
    }
    at += 2;
    if (marker >= kFirstAlone && marker <= kLastAlone) continue;
    if (is_frame_header(marker))
      check_extent(number_at(bytes, at + 5, 2), number_at(bytes, at + 3, 2));
    at += number_at(bytes, at, 2);
    if (marker != kScan) continue;
    // Within the scan 0xff is followed by 0, a restart mark or the next segment.
    for (;; ++at) {
      if (number_at(bytes, at, 1) != 0xff) continue;
      const std::uint32_t next = number_at(bytes, at + 1, 1);
      if (next != 0 && !(next >= kFirstAlone && next < kLastAlone)) break;
    }
  }
}

// A field of a TIFF directory that holds one number or a list of them (TIFF 6.0, section 2).
struct TiffField {
  std::uint32_t type = 0, count = 0;
  std::size_t at = 0;  // of the first value
};

class TiffReader {
 public:
  explicit TiffReader(std::string_view bytes)
      : bytes_(bytes), little_endian_(bytes.starts_with('I')) {}

  // Strips, or tiles, must lie within the file.
  void check() const {
    const std::size_t directory = number(4, 4);
    TiffField offsets, sizes;
    std::uint32_t width = 0, height = 0;
    const std::uint32_t field_count = number(directory, 2);
    for (std::uint32_t i = 0; i < field_count; ++i) {
      const std::size_t at = directory + 2 + 12 * std::size_t{i};
      const std::uint32_t tag = number(at, 2);
      if (tag == 256) width = value(field(at), 0);
      if (tag == 257) height = value(field(at), 0);
      if (tag == 273 || tag == 324) offsets = field(at);
      if (tag == 279 || tag == 325) sizes = field(at);
    }
    number(directory + 2 + 12 * std::size_t{field_count}, 4);  // of the next directory
    check_extent(width, height);
    if (offsets.count == 0 || offsets.count != sizes.count) {
      throw Error("the file is damaged: a TIFF without strips");
    }
    for (std::uint32_t i = 0; i < offsets.count; ++i) {
      const std::uint64_t end = std::uint64_t{value(offsets, i)} + value(sizes, i);
      if (end > bytes_.size()) {
        throw Error("the file is cut short, expected more than its ", bytes_.size(), " bytes");
      }
    }
  }

 private:
  std::uint32_t number(std::size_t at, std::size_t count) const {
    return number_at(bytes_, at, count, little_endian_);
  }
  static std::size_t value_size(const TiffField& field) { return field.type == 3 ? 2 : 4; }
  TiffField field(std::size_t at) const {
    TiffField field{number(at + 2, 2), number(at + 4, 4), at + 8};
    if (field.count * value_size(field) > 4) field.at = number(at + 8, 4);
    return field;
  }
  std::uint32_t value(const TiffField& field, std::uint32_t i) const {
    return number(field.at + i * value_size(field), value_size(field));
  }

  std::string_view bytes_;
  bool little_endian_ = false;
};

}  // namespace

PictureFormat check_picture_container(std::string_view bytes) {
  if (bytes.empty()) throw Error("the file is empty, expected a picture");
  if (bytes.starts_with(kPngSignature)) {
    check_png(bytes);
    return PictureFormat::png;
  }
  if (bytes.starts_with("\xff\xd8")) {
    check_jpeg(bytes);
    return PictureFormat::jpeg;
  }
  if (bytes.starts_with(std::string_view("II*\0", 4)) ||
      bytes.starts_with(std::string_view("MM\0*", 4))) {
    TiffReader(bytes).check();
    return PictureFormat::tiff;
  }
  throw Error("the file is no picture, expected PNG, JPEG or TIFF");
}

bool png_is_gray(std::string_view bytes) {
  constexpr std::size_t kColourType = 25;
  constexpr std::uint32_t kColour = 2;  // a bit: gray is 0, gray with alpha 4, a palette 3
  return (number_at(bytes, kColourType, 1) & kColour) == 0;
}

std::string png_without_remarks(std::string_view bytes) {
  std::string kept(kPngSignature);
  for (std::size_t at = kPngSignature.size(); at < bytes.size();) {
    const std::string_view chunk = png_chunk(bytes, at);
    const std::string_view type = chunk.substr(4, 4);
    // Types of chunks that a decoder needs begin with a capital; tRNS belongs to a palette.
    if ((byte_at(type, 0) & 0x20u) == 0 || type == "tRNS") kept += chunk;
    if (type == "IEND") break;
    at += chunk.size();
  }
  return kept;
}

}  // namespace tegata
