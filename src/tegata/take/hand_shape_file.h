// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tegata/hand/shape_parameters.h"
#include "tegata/hand/skeleton.h"

namespace tegata {

/// Somebody's hand as the built-in one in a shape.
struct HandShapeFile {
  std::string name;
  Side side = Side::right;
  ShapeParameters parameters = shape_prior().mean;
  std::optional<ShapeParameters> standard_deviations;
};

/// Whether a TOML is such a file rather than a scanned hand: it has the key `format`. Throws Error
/// where it cannot be read.
bool is_hand_shape_file(const std::filesystem::path& file);

/// Reads the TOML that docs/formats.md describes ("A hand's shape"). Parameters that it does not
/// name are those of the mean adult. Throws Error naming file and key for what is unknown, of
/// another type or no human hand's.
HandShapeFile read_hand_shape(const std::filesystem::path& file);

/// Writes it, with all parameters.
void write_hand_shape(const HandShapeFile& hand, const std::filesystem::path& file);

}  // namespace tegata
