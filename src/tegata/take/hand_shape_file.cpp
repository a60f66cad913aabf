// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/hand_shape_file.h"

#include <array>
#include <string_view>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

constexpr std::string_view kShapeFormat = "tegata-hand-shape";
constexpr double kShapeVersion = 1.0;
constexpr std::array<std::string_view, 6> kShapeKeys = {"format", "version", "name",
                                                        "hand",   "shape",   "standard_deviations"};

std::vector<std::string_view> parameter_names() {
  return {shape_parameter_names().begin(), shape_parameter_names().end()};
}

ShapeParameters read_parameters(const TomlTable& table, ShapeParameters parameters) {
  table.expect_keys(parameter_names());
  for (int i = 0; i < kShapeParameterCount; ++i) {
    const std::string& name = shape_parameter_names()[static_cast<std::size_t>(i)];
    if (table.has(name)) parameters[i] = table.positive_number(name);
  }
  return parameters;
}

std::string table_text(std::string_view name, const ShapeParameters& parameters) {
  std::string content = text("\n[", name, "]\n");
  for (int i = 0; i < kShapeParameterCount; ++i) {
    content += text(shape_parameter_names()[static_cast<std::size_t>(i)], " = ",
                    toml_number(parameters[i]), "\n");
  }
  return content;
}

}  // namespace

bool is_hand_shape_file(const std::filesystem::path& file) {
  return TomlTable::read(file).has("format");
}

HandShapeFile read_hand_shape(const std::filesystem::path& file) {
  const TomlTable root = TomlTable::read(file);
  root.expect_keys(kShapeKeys);
  if (root.string("format") != kShapeFormat) {
    root.fail("format", text("'", root.string("format"), "'"), text("'", kShapeFormat, "'"));
  }
  if (root.number("version") != kShapeVersion) {
    root.fail("version", toml_number(root.number("version")), "1");
  }
  HandShapeFile hand;
  hand.name = root.has("name") ? root.string("name") : file.stem().string();
  const std::string side = root.string("hand");
  if (side != side_name(Side::right) && side != side_name(Side::left)) {
    root.fail("hand", "'" + side + "'", "'right' or 'left'");
  }
  hand.side = side == side_name(Side::right) ? Side::right : Side::left;
  hand.parameters = read_parameters(root.table("shape"), hand.parameters);
  if (root.has("standard_deviations")) {
    hand.standard_deviations =
        read_parameters(root.table("standard_deviations"), shape_prior().deviation);
  }
  try {
    check_shape(shape_from_parameters(hand.parameters));
  } catch (const Error& error) {
    throw Error(file.string(), ": ", error.what());
  }
  return hand;
}

void write_hand_shape(const HandShapeFile& hand, const std::filesystem::path& file) {
  std::string content =
      text("format = \"", kShapeFormat, "\"\nversion = 1\nname = ", toml_string(hand.name),
           "\nhand = \"", side_name(hand.side), "\"\n", table_text("shape", hand.parameters));
  if (hand.standard_deviations) {
    content += table_text("standard_deviations", *hand.standard_deviations);
  }
  write_file(file, content);
}

}  // namespace tegata
