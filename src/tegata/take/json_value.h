// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tegata {

/// A value of a JSON file, read part by part. Every Error names the file and the value's place in
/// it ("result.json: frames[3].angles: ..."), what was got and what was expected.
class JsonValue {
 public:
  /// The root of a file.
  static JsonValue read(const std::filesystem::path& file);

  /// Of an object. at() throws where the key is missing.
  JsonValue at(std::string_view key) const;
  bool has(std::string_view key) const;
  std::vector<std::string> keys() const;
  /// Throws where there is a key that is not among these.
  void expect_keys(std::span<const std::string_view> known) const;

  /// Of an array.
  std::size_t size() const;
  JsonValue item(std::size_t index) const;

  std::string string() const;
  double number() const;
  int integer() const;
  /// An array of exactly `count` numbers.
  std::vector<double> numbers(std::size_t count) const;
  Eigen::Vector3d vector3() const;

  /// Throws Error: "<file>: <place>: got <got>, expected <expected>".
  [[noreturn]] void fail(std::string_view got, std::string_view expected) const;

 private:
  JsonValue(std::shared_ptr<const void> value, std::string file, std::string place);
  JsonValue part(const void* value, std::string place) const;

  std::shared_ptr<const void> value_;  ///< a nlohmann::json, which headers that are installed hide
  std::string file_, place_;
};

}  // namespace tegata
