// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/npz_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

std::size_t number_at(const std::string& bytes, std::size_t at, std::size_t width) {
  std::size_t number = 0;
  std::memcpy(&number, bytes.data() + at, width);
  return number;
}

// That NumPy reads it all is tested from the outside (tests/export_test.cpp).
TEST(NpzFile, EntryIsAnArrayWithItsHeader) {
  NpzFile npz;
  npz.add("numbers", {2, 2}, std::vector<double>{1.0, 2.0, 3.0, 4.5});
  const std::string bytes = npz.bytes();
  ASSERT_TRUE(bytes.starts_with(std::string("PK\x03\x04", 4)));
  EXPECT_EQ(bytes.substr(30, 11), "numbers.npy");
  const std::size_t array = 41, header = number_at(bytes, array + 8, 2);
  EXPECT_EQ(bytes.substr(array, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_EQ((10 + header) % 64, 0U);
  EXPECT_EQ(number_at(bytes, 18, 4), 10 + header + 4 * 8);
  double last = 0.0;
  std::memcpy(&last, bytes.data() + array + 10 + header + 24, 8);
  EXPECT_EQ(last, 4.5);
  EXPECT_EQ(number_at(bytes, bytes.size() - 12, 2), 1U);  // entries
}

TEST(NpzFile, ChecksumIsThatOfZip) {
  NpzFile npz;
  npz.add("a", {1}, std::vector<std::int32_t>{7});
  const std::string bytes = npz.bytes();
  const std::size_t size = number_at(bytes, 18, 4);
  std::uint32_t sum = ~0U;  // bit by bit
  for (const char c : bytes.substr(30 + 5, size)) {
    sum ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum & 1U ? sum >> 1 ^ 0xEDB88320U : sum >> 1;
  }
  EXPECT_EQ(number_at(bytes, 14, 4), ~sum);
}

TEST(NpzFile, ShapeThatDoesNotFitIsRefused) {
  NpzFile npz;
  EXPECT_TRUE(says(error_of([&] {
                     npz.add("a", {3}, std::vector<double>{1.0, 2.0});
                   }),
                   "'a'", "got 2", "expected 3"));
}

TEST(NpzFile, SameArraysGiveTheSameBytes) {
  const auto bytes = [] {
    NpzFile npz;
    npz.add("names", {"one", "zwölf"});
    npz.add("flags", {2}, std::vector<bool>{true, false});
    return npz.bytes();
  };
  EXPECT_EQ(bytes(), bytes());
}

}  // namespace
}  // namespace tegata
