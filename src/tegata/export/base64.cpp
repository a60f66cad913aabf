// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/base64.h"

#include <string_view>

namespace tegata {

std::string encode_base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string encoded;
  encoded.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&bytes, i](std::size_t k) -> std::uint32_t {
      return i + k < bytes.size() ? bytes[i + k] : 0u;
    };
    const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
    encoded += kLetters[group >> 18 & 63u];
    encoded += kLetters[group >> 12 & 63u];
    encoded += i + 1 < bytes.size() ? kLetters[group >> 6 & 63u] : '=';
    encoded += i + 2 < bytes.size() ? kLetters[group & 63u] : '=';
  }
  return encoded;
}

}  // namespace tegata
