// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tegata/take/picture_file.h"

namespace tegata {

/// The bytes of an AVI of JPEG pictures (Motion JPEG), all of one size.
inline std::string motion_jpeg_avi(const std::vector<CameraImage>& pictures) {
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffu);
    return bytes;
  };
  const auto chunk = [&](std::string_view name, std::string content) {
    const auto size = static_cast<std::uint32_t>(content.size());
    if (content.size() % 2 == 1) content += '\0';
    return std::string(name) + number(size) + content;
  };
  const auto width = static_cast<std::uint32_t>(pictures.front().values.width());
  const auto height = static_cast<std::uint32_t>(pictures.front().values.height());
  const auto count = static_cast<std::uint32_t>(pictures.size());
  std::string main_header, stream_header = "vidsMJPG", format;
  for (const std::uint32_t field :
       {33333u, 0u, 0u, 0x10u, count, 0u, 1u, 0u, width, height, 0u, 0u, 0u, 0u}) {
    main_header += number(field);
  }
  for (const std::uint32_t field : {0u, 0u, 0u, 1u, 30u, 0u, count, 0u, 0u, 0u, 0u, 0u}) {
    stream_header += number(field);
  }
  for (const std::uint32_t field : {40u, width, height, 1u | 24u << 16}) format += number(field);
  format += "MJPG";
  for (int i = 0; i < 5; ++i) format += number(0);
  std::string pieces = "movi", index;
  for (const CameraImage& picture : pictures) {
    const std::vector<std::uint8_t> jpeg = encode_jpeg(picture, 95);
    index += "00dc" + number(0x10) + number(static_cast<std::uint32_t>(pieces.size())) +
             number(static_cast<std::uint32_t>(jpeg.size()));
    pieces += chunk("00dc", std::string(jpeg.begin(), jpeg.end()));
  }
  const std::string headers =
      "hdrl" + chunk("avih", main_header) +
      chunk("LIST", "strl" + chunk("strh", stream_header) + chunk("strf", format));
  return chunk("RIFF",
               "AVI " + chunk("LIST", headers) + chunk("LIST", pieces) + chunk("idx1", index));
}

}  // namespace tegata
