// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tegata {

/// A table of a TOML file, read key by key. Every Error names the file, the table and the key, what
/// was got and what was expected.
class TomlTable {
 public:
  /// The root table of a file.
  static TomlTable read(const std::filesystem::path& file);

  /// The file and the table, to begin messages with: "take.toml: [initial_pose] ".
  const std::string& where() const { return where_; }
  /// In the order of the file.
  std::vector<std::string> keys() const;
  bool has(std::string_view key) const;
  bool is_table(std::string_view key) const;
  /// Whether the value is an array of arrays.
  bool is_matrix(std::string_view key) const;
  /// Throws where there is a key that is not among these; `passed_over` are not recommended.
  void expect_keys(std::span<const std::string_view> known,
                   std::span<const std::string_view> passed_over = {}) const;

  TomlTable table(std::string_view key) const;
  std::string string(std::string_view key) const;
  bool flag(std::string_view key) const;
  /// A finite number, with or without a point.
  double number(std::string_view key) const;
  /// A finite number above zero.
  double positive_number(std::string_view key) const;
  /// A whole number within bounds, both included.
  int whole_number(std::string_view key, int least, int most) const;
  std::vector<double> numbers(std::string_view key) const;
  Eigen::Vector3d vector3(std::string_view key) const;
  Eigen::Matrix3d matrix3(std::string_view key) const;

  /// Throws Error: "<where>key '<key>': got <got>, expected <expected>".
  [[noreturn]] void fail(std::string_view key, std::string_view got,
                         std::string_view expected) const;

 private:
  TomlTable(std::shared_ptr<const void> table, std::string file, std::string path);

  std::shared_ptr<const void> table_;  ///< a toml::table, which headers that are installed hide
  std::string file_, path_, where_;
};

/// The shortest TOML float that reads back as the same number.
std::string toml_number(double number);
/// "[1.0, 2.0]".
std::string toml_numbers(std::span<const double> numbers);
/// A quoted TOML string.
std::string toml_string(std::string_view string);

/// "'a', 'b' or 'c'".
std::string one_of(std::span<const std::string_view> names);

}  // namespace tegata
