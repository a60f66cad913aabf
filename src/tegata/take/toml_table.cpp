// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/toml_table.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

const toml::table& as_table(const std::shared_ptr<const void>& table) {
  return *static_cast<const toml::table*>(table.get());
}

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

// The value of a key, which must be there.
const toml::node& node_of(const TomlTable& where, const std::shared_ptr<const void>& table,
                          std::string_view key, std::string_view expected) {
  const toml::node* node = as_table(table).get(key);
  if (node == nullptr)
    throw Error(where.where(), "key '", key, "' is missing, expected ", expected);
  return *node;
}

double finite_number(const TomlTable& where, std::string_view key, const toml::node& node) {
  if (!node.is_number()) where.fail(key, kind_of(node), "a number");
  // As a double it has no value() where it is a whole number with more digits than that holds.
  const double number = node.is_integer() ? static_cast<double>(node.value<std::int64_t>().value())
                                          : node.value<double>().value();
  if (!std::isfinite(number)) where.fail(key, text(number), "a finite number");
  return number;
}

std::vector<double> finite_numbers(const TomlTable& where, std::string_view key,
                                   const toml::node& node) {
  const toml::array* array = node.as_array();
  if (array == nullptr) where.fail(key, kind_of(node), "an array of numbers");
  std::vector<double> numbers;
  numbers.reserve(array->size());
  for (const toml::node& item : *array) numbers.push_back(finite_number(where, key, item));
  return numbers;
}

}  // namespace

TomlTable::TomlTable(std::shared_ptr<const void> table, std::string file, std::string path)
    : table_(std::move(table)), file_(std::move(file)), path_(std::move(path)) {
  where_ = path_.empty() ? file_ + ": " : text(file_, ": [", path_, "] ");
}

TomlTable TomlTable::read(const std::filesystem::path& file) {
  const std::string content = read_file(file);
  try {
    return {std::make_shared<const toml::table>(toml::parse(content)), file.string(), ""};
  } catch (const toml::parse_error& error) {
    std::string reason(error.description());
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(file.string(), ": line ", error.source().begin.line, ": not TOML: ", reason);
  }
}

std::vector<std::string> TomlTable::keys() const {
  using Position = std::pair<toml::source_index, toml::source_index>;
  std::vector<std::pair<Position, std::string>> found;
  for (const auto& [key, node] : as_table(table_)) {
    const toml::source_position& begin = key.source().begin;
    found.emplace_back(Position(begin.line, begin.column), std::string(key.str()));
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> keys;
  keys.reserve(found.size());
  for (auto& [position, key] : found) keys.push_back(std::move(key));
  return keys;
}

bool TomlTable::has(std::string_view key) const { return as_table(table_).contains(key); }

bool TomlTable::is_table(std::string_view key) const {
  const toml::node* node = as_table(table_).get(key);
  return node != nullptr && node->is_table();
}

bool TomlTable::is_matrix(std::string_view key) const {
  const toml::node* node = as_table(table_).get(key);
  return node != nullptr && node->is_array() && !node->as_array()->empty() &&
         node->as_array()->front().is_array();
}

void TomlTable::expect_keys(std::span<const std::string_view> known,
                            std::span<const std::string_view> passed_over) const {
  const auto among = [](std::span<const std::string_view> names, const std::string& key) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  for (const std::string& key : keys()) {
    if (!among(known, key) && !among(passed_over, key)) {
      throw Error(where_, "key '", key, "' is unknown, expected ", one_of(known));
    }
  }
}

TomlTable TomlTable::table(std::string_view key) const {
  const toml::node& node = node_of(*this, table_, key, "a table");
  if (!node.is_table()) fail(key, kind_of(node), "a table");
  std::string path = path_.empty() ? std::string(key) : text(path_, ".", key);
  return {std::shared_ptr<const void>(table_, node.as_table()), file_, std::move(path)};
}

std::string TomlTable::string(std::string_view key) const {
  const toml::node& node = node_of(*this, table_, key, "a string");
  if (!node.is_string()) fail(key, kind_of(node), "a string");
  return node.as_string()->get();
}

bool TomlTable::flag(std::string_view key) const {
  const toml::node& node = node_of(*this, table_, key, "true or false");
  if (!node.is_boolean()) fail(key, kind_of(node), "true or false");
  return node.as_boolean()->get();
}

double TomlTable::number(std::string_view key) const {
  return finite_number(*this, key, node_of(*this, table_, key, "a number"));
}

double TomlTable::positive_number(std::string_view key) const {
  const double value = number(key);
  if (!(value > 0.0)) fail(key, text(value), "a number above 0");
  return value;
}

int TomlTable::whole_number(std::string_view key, int least, int most) const {
  const double value = number(key);
  if (value != std::floor(value) || value < least || value > most) {
    fail(key, text(value), text("a whole number of ", least, " to ", most));
  }
  return static_cast<int>(value);
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
  return finite_numbers(*this, key, node_of(*this, table_, key, "an array of numbers"));
}

Eigen::Vector3d TomlTable::vector3(std::string_view key) const {
  const std::vector<double> values = numbers(key);
  if (values.size() != 3) fail(key, text(values.size(), " numbers"), "3 numbers");
  return {values[0], values[1], values[2]};
}

Eigen::Matrix3d TomlTable::matrix3(std::string_view key) const {
  constexpr std::string_view kExpected = "3 rows of 3 numbers";
  const toml::node& node = node_of(*this, table_, key, kExpected);
  const toml::array* rows = node.as_array();
  if (rows == nullptr) fail(key, kind_of(node), kExpected);
  if (rows->size() != 3) fail(key, text("an array of ", rows->size()), kExpected);
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    const toml::node& row = (*rows)[static_cast<std::size_t>(i)];
    if (!row.is_array()) fail(key, text(kind_of(row), " as row ", i + 1), kExpected);
    const std::vector<double> values = finite_numbers(*this, key, row);
    if (values.size() != 3) {
      fail(key, text(values.size(), " numbers in row ", i + 1), kExpected);
    }
    matrix.row(i) << values[0], values[1], values[2];
  }
  return matrix;
}

void TomlTable::fail(std::string_view key, std::string_view got, std::string_view expected) const {
  throw Error(where_, "key '", key, "': got ", got, ", expected ", expected);
}

std::string toml_number(double number) {
  std::array<char, 64> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  std::string written(digits.data(), end);
  if (written.find_first_of(".en") == std::string::npos) written += ".0";
  return written;
}

std::string toml_numbers(std::span<const double> numbers) {
  std::string list;
  for (const double number : numbers) list += (list.empty() ? "" : ", ") + toml_number(number);
  return "[" + list + "]";
}

std::string toml_string(std::string_view string) {
  static constexpr std::string_view kHex = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : string) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (code < 0x20 || code == 0x7f) {
      quoted += "\\u00";
      quoted += kHex[code >> 4];
      quoted += kHex[code & 15u];
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string one_of(std::span<const std::string_view> names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += text("'", names[i], "'");
  }
  return list;
}

}  // namespace tegata
