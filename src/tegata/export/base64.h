// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tegata {

/// Base64 with padding (RFC 4648, section 4).
std::string encode_base64(std::span<const std::uint8_t> bytes);

}  // namespace tegata
