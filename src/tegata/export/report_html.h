// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tegata {

/// Text as it stands in HTML, attribute values included.
std::string escape_html(std::string_view text);

/// Base64 with padding (RFC 4648, section 4).
std::string encode_base64(const std::vector<std::uint8_t>& bytes);

/// "thumb_cmc_abduction" as people read it: "thumb CMC abduction".
std::string spoken_name(std::string_view name);

}  // namespace tegata
