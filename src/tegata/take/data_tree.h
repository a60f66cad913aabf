// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tegata {

/// A node of a YAML, JSON or OpenCV XML file, read key by key. Every Error names the file, the path
/// to the node, what was got and what was expected.
class DataTree {
 public:
  /// The root of a file, which is told to be XML by its first character. Files of more than 4 MB
  /// are refused: a calibration has some hundred numbers.
  static DataTree read(const std::filesystem::path& file);
  /// The same from a file's bytes; `file` is for messages.
  static DataTree parse(const std::string& content, const std::string& file);

  /// The file and the path: "intri.yml: 'K_01'".
  const std::string& where() const { return where_; }
  bool is_map() const;
  bool is_sequence() const;
  /// Of a map, in the order of the file.
  std::vector<std::string> keys() const;
  bool has(std::string_view key) const;
  /// A key of a map, which must be there.
  DataTree child(std::string_view key) const;
  /// The first of several keys that is there; `expected` in the Error where none is.
  DataTree child_of(const std::vector<std::string_view>& keys) const;
  /// Of a sequence.
  std::vector<DataTree> items() const;

  /// A scalar as it is written: "01" stays "01".
  std::string string() const;
  /// A finite number.
  double number() const;
  /// All finite numbers of a scalar, of a sequence, of a sequence of sequences or of an OpenCV
  /// matrix, row by row.
  std::vector<double> numbers() const;
  /// As many numbers.
  std::vector<double> numbers(std::size_t count) const;
  Eigen::Vector3d vector3() const;
  Eigen::Matrix3d matrix3() const;

  /// Throws Error: "<where>: got <got>, expected <expected>".
  [[noreturn]] void fail(std::string_view got, std::string_view expected) const;

 private:
  DataTree(std::shared_ptr<const void> node, std::string file, std::string path);
  void append_numbers(std::vector<double>& numbers, int depth) const;

  std::shared_ptr<const void> node_;  ///< a YAML::Node, which headers that are installed hide
  std::string file_, path_, where_;
};

}  // namespace tegata
