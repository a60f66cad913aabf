// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tegata {

/// NumPy's archive of arrays (.npz): a zip file of .npy files, stored without compression. What it
/// writes are version 1.0 .npy headers, little-endian numbers in C order, and the zip records that
/// such files need (PKWARE's APPNOTE, 4.3), without their 64-bit extensions.
class NpzFile {
 public:
  using Shape = std::vector<std::size_t>;

  /// Each adds an array. Throws Error where the shape does not have as many elements as are given.
  void add(std::string_view name, const Shape& shape, const std::vector<double>& numbers);
  void add(std::string_view name, const Shape& shape, const std::vector<float>& numbers);
  void add(std::string_view name, const Shape& shape, const std::vector<std::int32_t>& numbers);
  void add(std::string_view name, const Shape& shape, const std::vector<bool>& flags);
  /// As Unicode strings (numpy's <U), all as wide as the widest; in UTF-8 here.
  void add(std::string_view name, const std::vector<std::string>& texts);

  /// The whole file. Throws Error beyond 4 GB, where the 32-bit records end.
  std::string bytes() const;

 private:
  void add_array(std::string_view name, std::string_view type, const Shape& shape,
                 std::string_view content);

  struct Entry {
    std::string name, content;
  };
  std::vector<Entry> entries_;
};

}  // namespace tegata
