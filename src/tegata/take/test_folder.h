// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "tegata/base/error.h"

namespace tegata {

/// A new empty folder for one test; it is removed with everything in it.
class TestFolder {
 public:
  TestFolder() {
    static int count = 0;  // a test may have several
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ =
        std::filesystem::temp_directory_path() /
        text("tegata-", test->test_suite_name(), "-", test->name(), "-", ::getpid(), "-", count++);
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The message of the Error that `function` throws; a failure and an empty string if it throws
/// none.
template <typename Function>
std::string error_of(const Function& function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "expected an Error";
  return {};
}

/// Whether all parts occur in a message.
template <typename... Parts>
testing::AssertionResult says(const std::string& message, const Parts&... parts) {
  for (const std::string& part : {std::string(parts)...}) {
    if (message.find(part) == std::string::npos) {
      return testing::AssertionFailure() << "'" << message << "' does not say '" << part << "'";
    }
  }
  if (message.find('\n') != std::string::npos) {
    return testing::AssertionFailure() << "'" << message << "' is more than one line";
  }
  return testing::AssertionSuccess();
}

}  // namespace tegata
