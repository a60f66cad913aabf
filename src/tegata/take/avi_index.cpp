// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/avi_index.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace tegata {
namespace {

constexpr std::uint64_t kChunkHead = 8;  // type and size, four bytes each

// The head of a chunk (a piece of a RIFF file), or an entry of the index, which begins like one.
struct ChunkHead {
  std::string type;
  std::uint32_t size = 0;
};

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return number;
}

class AviFile {
 public:
  explicit AviFile(const std::filesystem::path& file) : stream_(file, std::ios::binary) {}

  // Empty past the end.
  std::string bytes(std::uint64_t position, std::size_t count) {
    std::string read(count, '\0');
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(position));
    if (!stream_.read(read.data(), static_cast<std::streamsize>(count))) return {};
    return read;
  }
  std::optional<ChunkHead> head(std::uint64_t position) {
    const std::string read = bytes(position, kChunkHead);
    if (read.empty()) return std::nullopt;
    return ChunkHead{read.substr(0, 4), little_endian(std::string_view(read).substr(4))};
  }

 private:
  std::ifstream stream_;
};

// "00dc" and "01db" are pictures, of the streams 0 and 1; sound ends in "wb".
bool is_picture(std::string_view type) { return type.ends_with("dc") || type.ends_with("db"); }

}  // namespace

AviIndex read_avi_index(const std::filesystem::path& file) {
  AviFile avi(file);
  const std::string start = avi.bytes(0, 12);
  if (!start.starts_with("RIFF") || !start.ends_with("AVI ")) return {};
  std::uint64_t pictures = 0;  // where the list of them has its type, from which positions count
  std::string entries;
  for (std::uint64_t at = 12; const auto head = avi.head(at);) {
    const std::uint64_t content = at + kChunkHead;
    if (head->type == "LIST" && avi.bytes(content, 4) == "movi") pictures = content;
    if (head->type == "idx1" && head->size % 16 == 0 &&
        head->size <= std::filesystem::file_size(file)) {
      entries = avi.bytes(content, head->size);
      break;
    }
    at = content + head->size + head->size % 2;
  }
  AviIndex index;
  std::string stream;
  for (std::size_t at = 0; pictures > 0 && at < entries.size(); at += 16) {
    const std::string_view entry = std::string_view(entries).substr(at, 16);
    if (!is_picture(entry.substr(0, 4))) continue;
    if (stream.empty()) stream = entry.substr(0, 4);
    if (entry.substr(0, 4) != stream) return {};  // several: which is decoded is not known here
    const std::uint32_t position = little_endian(entry.substr(8)),
                        size = little_endian(entry.substr(12));
    // Counted from the list or, by some writers, from the beginning of the file.
    for (const std::uint64_t from : {pictures, std::uint64_t{0}}) {
      const auto head = avi.head(from + position);
      if (!head || head->type != stream || head->size != size) continue;
      index.found.push_back(index.count);
      break;
    }
    ++index.count;
  }
  return index;
}

}  // namespace tegata
