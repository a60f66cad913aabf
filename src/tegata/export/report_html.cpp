// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_html.h"

#include <array>

namespace tegata {

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string encode_base64(const std::vector<std::uint8_t>& bytes) {
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

std::string spoken_name(std::string_view name) {
  constexpr std::array<std::string_view, 5> kJoints = {"cmc", "mcp", "pip", "dip", "ip"};
  std::string spoken;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find('_'), name.size());
    std::string word(name.substr(0, end));
    name.remove_prefix(std::min(end + 1, name.size()));
    for (const std::string_view joint : kJoints) {
      if (word == joint) {
        for (char& c : word) c = static_cast<char>(c - 'a' + 'A');
      }
    }
    spoken += (spoken.empty() ? "" : " ") + word;
  }
  return spoken;
}

}  // namespace tegata
