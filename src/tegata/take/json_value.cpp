// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/json_value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

using nlohmann::json;

const json& as_json(const std::shared_ptr<const void>& value) {
  return *static_cast<const json*>(value.get());
}

std::string kind_of(const json& value) {
  if (value.is_null()) return "null";
  if (value.is_array()) return text("an array of ", value.size());
  const std::string name = value.type_name();
  return (name == "object" ? "an " : "a ") + name;
}

}  // namespace

JsonValue::JsonValue(std::shared_ptr<const void> value, std::string file, std::string place)
    : value_(std::move(value)), file_(std::move(file)), place_(std::move(place)) {}

JsonValue JsonValue::read(const std::filesystem::path& file) {
  const std::string content = read_file(file);
  try {
    return {std::make_shared<const json>(json::parse(content)), file.string(), ""};
  } catch (const json::exception& error) {
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(file.string(), ": not JSON: ", reason);
  }
}

JsonValue JsonValue::part(const void* value, std::string place) const {
  return {std::shared_ptr<const void>(value_, value), file_, std::move(place)};
}

JsonValue JsonValue::at(std::string_view key) const {
  const json& object = as_json(value_);
  if (!object.is_object()) fail(kind_of(object), "an object");
  const auto found = object.find(key);
  if (found == object.end()) {
    throw Error(file_, ": ", place_, place_.empty() ? "" : ": ", "key '", key, "' is missing");
  }
  return part(&*found, place_.empty() ? std::string(key) : text(place_, ".", key));
}

bool JsonValue::has(std::string_view key) const {
  const json& object = as_json(value_);
  if (!object.is_object()) fail(kind_of(object), "an object");
  return object.contains(key);
}

std::vector<std::string> JsonValue::keys() const {
  const json& object = as_json(value_);
  if (!object.is_object()) fail(kind_of(object), "an object");
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

void JsonValue::expect_keys(std::span<const std::string_view> known) const {
  for (const std::string& key : keys()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw Error(file_, ": ", place_, place_.empty() ? "" : ": ", "key '", key,
                  "' is unknown, expected ", one_of(known));
    }
  }
}

std::size_t JsonValue::size() const {
  const json& array = as_json(value_);
  if (!array.is_array()) fail(kind_of(array), "an array");
  return array.size();
}

JsonValue JsonValue::item(std::size_t index) const {
  if (index >= size()) fail(text("an array of ", size()), text("an item ", index));
  return part(&as_json(value_)[index], text(place_, "[", index, "]"));
}

std::string JsonValue::string() const {
  const json& value = as_json(value_);
  if (!value.is_string()) fail(kind_of(value), "a string");
  return value.get<std::string>();
}

double JsonValue::number() const {
  const json& value = as_json(value_);
  if (!value.is_number()) fail(kind_of(value), "a number");
  return value.get<double>();
}

int JsonValue::integer() const {
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > 1e9) fail(text(value), "a whole number");
  return static_cast<int>(value);
}

std::vector<double> JsonValue::numbers(std::size_t count) const {
  if (size() != count) fail(text("an array of ", size()), text(count, " numbers"));
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(item(i).number());
  return numbers;
}

Eigen::Vector3d JsonValue::vector3() const {
  const std::vector<double> values = numbers(3);
  return {values[0], values[1], values[2]};
}

void JsonValue::fail(std::string_view got, std::string_view expected) const {
  throw Error(file_, ": ", place_, place_.empty() ? "" : ": ", "got ", got, ", expected ",
              expected);
}

}  // namespace tegata
