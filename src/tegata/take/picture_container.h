// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tegata {

/// The kinds of picture files that are read.
enum class PictureFormat { png, jpeg, tiff };

/// Tells the format by the first bytes and walks the file's structure to its end, because decoders
/// give back half a picture for half a file and say so nowhere but on the terminal: PNG chunks with
/// their checksums, JPEG segments up to the end mark, the extents of a TIFF's first directory.
/// Throws Error (without the file's name) for anything else and for files that are cut short or
/// damaged.
PictureFormat check_picture_container(std::string_view bytes);

/// Whether a checked PNG has one channel, alpha aside.
bool png_is_gray(std::string_view bytes);

/// A checked PNG without the chunks that say nothing of its pixels (text, times, colour profiles).
std::string png_without_remarks(std::string_view bytes);

}  // namespace tegata
